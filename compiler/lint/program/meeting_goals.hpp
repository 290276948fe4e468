// Which components can be asked for different modes at the same time, as far as the shape of a program tells.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/program.hpp"

namespace rmpl::compiler {

/// The components of which two goals stand on two ways that a program goes at the same time: ways that begin where
/// several locations are marked together, within the composite that holds them. No other component is ever asked for
/// two modes in one cycle. Ascending. Costs locations times their depth.
std::vector<automata::VariableId> components_of_meeting_goals(const automata::Program& program);

}  // namespace rmpl::compiler
