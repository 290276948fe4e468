// Names as they are inside: without the path of what holds them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "automata/plant.hpp"

namespace rmpl::compiler {

/// The plant's variables, those of an instance without its path where that leaves each name its own. Linear.
automata::Variables own_names(const automata::Plant& plant, std::string_view instance);

/// Whether a name is one of an instance: `engine.temp` of `engine`, and all names of the empty one, the plant.
bool is_of(std::string_view name, std::string_view instance);

}  // namespace rmpl::compiler
