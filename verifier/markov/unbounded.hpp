// Probabilities and mean times without end, under all choices.
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "verifier/markov/decision_process.hpp"

namespace rmpl::verifier {

// Where the graph decides, answers are exact. A chain is solved by elimination. Of choices the best policy is found
// (policy.hpp); by how much one step more would change what it is worth bounds how far it is from the best, whatever
// was rounded on the way. Both end, however long runs are. Throws LimitReached.

/// The least or the greatest probability of ever coming to what is wanted, at the start. For the greatest, what may
/// stay together for ever is one state (S. Haddad, B. Monmege: Reachability in MDPs: refining convergence of value
/// iteration, 2014).
Enclosure ever(const DecisionProcess& decisions, Aim aim, Meter& meter);

/// The mean of the steps until what is wanted, at the start; both bounds are `unbounded_time` where some run of
/// positive probability never comes to it, under all choices (least) or some (greatest).
Enclosure mean_steps(const DecisionProcess& decisions, Aim aim, Meter& meter);

inline constexpr Real unbounded_time = std::numeric_limits<Real>::infinity();

}  // namespace rmpl::verifier
