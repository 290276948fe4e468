// Markov decision processes in rational numbers, policy by policy: the twin of what verifier/markov says of runs
// without end. SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "tests/reference/probability.hpp"

namespace rmpl::reference {

/// By state: choices, each of which leads to states with probabilities that sum to 1. A run ends where there is none.
struct RationalProcess {
  using Choice = std::vector<std::pair<std::size_t, Rational>>;
  std::vector<std::vector<Choice>> choices;
  std::vector<bool> wanted;
};

/// Over all policies, the mean of the steps until a wanted state; none: infinite.
struct MeanSteps {
  std::optional<Rational> least, greatest;
};

/// Over all policies that choose by the state alone, among which are the best and the worst. Cost: a system of
/// equations for each policy.
Probabilities ever(const RationalProcess& process, std::size_t start);
MeanSteps mean_steps(const RationalProcess& process, std::size_t start);

}  // namespace rmpl::reference
