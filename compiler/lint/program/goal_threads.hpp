// The part of a program that has to do with the goals of one component.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/program.hpp"

namespace rmpl::compiler {

/// Per location, whether some run leads from it, or by its end, to a location that asserts a mode of the component, or
/// to the start of a clock that decides on the way there. What is left out decides nothing about those.
std::vector<bool> goal_threads(const automata::Program& program, automata::VariableId component);

}  // namespace rmpl::compiler
