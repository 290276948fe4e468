// The modes in which the components of a plant can start.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/state.hpp"

namespace rmpl::verifier {

/// By component, ascending: the modes that `from` gives it, or else those of positive probability at the start.
std::vector<std::vector<automata::ModeId>> initial_modes(const automata::Plant& plant,
                                                         const std::vector<automata::Assignment>& from);

/// Throws base::InputError where `from` names what is no mode of a component, or one component twice.
void demand_modes(const automata::Plant& plant, const std::vector<automata::Assignment>& from);
/// Throws base::InputError: `from` gives modes in which no state to start in is possible.
[[noreturn]] void refuse_start();

}  // namespace rmpl::verifier
