// Observation files of the diagnostic competition (DXC): the readings to explain.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/plant.hpp"

namespace rmpl::tools {

/// The last `sensors @T { x = true, … };` of a file, over the plant's variables, sorted; a reading `x` may name the
/// output `x.o` of a gate. Throws base::InputError, with the line, where there is none, or where it names what the
/// plant lacks.
std::vector<automata::Assignment> competition_observation(const std::string& path, const automata::Plant& plant);

}  // namespace rmpl::tools
