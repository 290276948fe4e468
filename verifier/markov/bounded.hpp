// The least and the greatest probability of coming to what is wanted within some steps, under all choices.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "verifier/markov/decision_process.hpp"

namespace rmpl::verifier {

/// By number of steps, as asked for, ascending: the probability at the start. Choices may depend on all that has
/// happened. Backward induction (M. Puterman: Markov Decision Processes, 4.5): O(steps * edges), less where values stop
/// to change.
std::vector<Enclosure> within_steps(const DecisionProcess& decisions, Aim aim, const std::vector<Units>& steps,
                                    Meter& meter);

}  // namespace rmpl::verifier
