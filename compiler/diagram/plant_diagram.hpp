// A plant as a block diagram, in the manner of thesis Fig. 7-7.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "automata/plant.hpp"

namespace rmpl::compiler {

/// The inside of a plant, or of the module `inside`, in DOT: components as boxes with type and ports, modules as boxes
/// around them or folded into one (`compiler/diagram/blocks.hpp` for `depth`). Interconnections are lines from port to
/// port, those that are no equality with their constraint; one of more than two ends, or of a single one, is a note.
/// Ports that nobody connects, commands or observes are counted, not drawn. Each interconnection `q1`, by its number
/// from 1, stands in the `id` of one line or in the name of one note; only those inside a folded module are not drawn,
/// and those that have no end inside.
std::string plant_diagram(const automata::Plant& plant, std::string_view inside, std::optional<std::size_t> depth);

}  // namespace rmpl::compiler
