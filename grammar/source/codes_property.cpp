// Codes of the registry: properties.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array table = {
    CodeInfo{Code::no_property, "no property", "A file of properties states at least one.", "faults 1;",
             R"(faults 1; property "p" { never engine = failed; })"},
    CodeInfo{Code::property_without_claim, "property claims nothing",
             "A property makes one claim: `never`, `reach` or `after … within …`.", R"(property "p" { faults 1; })",
             R"(property "p" { never engine = failed; faults 1; })"},
    CodeInfo{
        Code::property_repeated_part, "property says a thing twice",
        "A property has a name of its own and makes one claim; a setting is made once, and so is one for the file.",
        R"(property "p" { never engine = failed; faults 1; faults 2; })",
        R"(property "p" { never engine = failed; faults 2; })"},
    CodeInfo{Code::property_not_a_mode, "not a mode", "`from` gives modes of components, each once, to start in.",
             "from engine.thrust = full;", "from engine = firing;"},
    CodeInfo{Code::property_period, "period out of range", "Steps happen at multiples of a period longer than 0.",
             "time 0 s;", "time 0.5 s;"},
};

}  // namespace

std::span<const CodeInfo> property_codes() { return table; }

}  // namespace rmpl::grammar
