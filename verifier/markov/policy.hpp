// The best choices of a Markov decision process without end, and how far from the best they may be.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "verifier/markov/decision_process.hpp"

namespace rmpl::verifier {

/// By state: the choices that there are. None where a run ends.
using Choices = std::vector<std::vector<const Row*>>;

/// What a policy is worth.
enum class Payment {
  each_step,  ///< the mean number of steps until the end
  at_end      ///< the probability of an end that pays; of what is left out, nothing is known
};

/// What the best policy that was found is worth, by state.
struct BestPolicy {
  std::vector<Real> values;
  std::vector<Enclosure> certain;  ///< bounds of what it is worth
  /// By what one step more, and its payment, makes values greater at most: whatever is chosen where the greatest is
  /// asked for, else by what the policy chooses.
  Real above = 0;
  Real below = 0;  ///< the same, smaller: whatever is chosen where the least is asked for
};

/// Makes a policy better until no other choice is certain to be so (R. Howard: Dynamic Programming and Markov
/// Processes, 1960). Policies are solved by elimination, so that long runs cost no more than short ones. From each
/// state with choices some of them lead to an end with probability 1; where each step pays and the greatest is asked
/// for, or the end pays, all of them do. Throws LimitReached.
BestPolicy best_policy(const Choices& choices, const std::vector<bool>& pays, Payment payment, Aim aim, Meter& meter);

}  // namespace rmpl::verifier
