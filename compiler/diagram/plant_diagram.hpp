// A plant as a block diagram, in the manner of thesis Fig. 7-7.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "automata/plant.hpp"

namespace rmpl::compiler {

/// Whether the lower edge of a block leaves room for the name of a mode, for who shows in it what holds.
enum class Badges { none, room };

/// The inside of a plant, or of the module `inside`, in DOT: components as boxes with type and ports, modules as boxes
/// around them or folded into one (`compiler/diagram/blocks.hpp` for `depth`). Interconnections are lines from port to
/// port, those that are no equality with their constraint in the middle; one of more than two ends, or of a single one,
/// is a note. Ports that nobody connects, commands or observes are counted, not drawn. Each interconnection `q1`, by
/// its number from 1, stands in the `id` of one line or in the name of one constraint or note; only those inside a
/// folded module are not drawn, and those that have no end inside.
std::string plant_diagram(const automata::Plant& plant, std::string_view inside, std::optional<std::size_t> depth,
                          Badges badges = Badges::none);

}  // namespace rmpl::compiler
