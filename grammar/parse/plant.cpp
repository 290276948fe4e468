// Whole `.tcca` files: imports, domains, components, modules, the plant.
// SPDX-License-Identifier: MIT
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {
namespace {

constexpr auto items = &PlantFile::items;
const auto plant_file_def = record[statements_of_file(
    "`component`, `module`, `plant`, `domain` or `import`",
    append<items>[import] | append<items>[domain] | append<items>[component] | append<items>[module_])];

}  // namespace

BOOST_SPIRIT_DEFINE(plant_file)
BOOST_SPIRIT_INSTANTIATE(decltype(plant_file), Iterator, Context)

}  // namespace rmpl::grammar
