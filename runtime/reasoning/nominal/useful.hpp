// Which steps lead towards a goal: what is wanted of each component, and of those that decide its steps.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "automata/plant.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"

namespace rmpl::runtime {

/// Modes of a component of which one is wanted, as a mask.
using WantedModes = std::pair<automata::ComponentId, std::vector<bool>>;

/// A transition is useful if it leaves a mode that is not wanted, and leads to one that is; what its preconditions ask
/// of other components is wanted, too. A plan takes other steps only to keep out of the way of something: these are the
/// steps of the causal chains of Williams and Nayak (1997), whatever modes they begin in.
class UsefulSteps {
 public:
  UsefulSteps(const NominalGraph& graph, std::vector<WantedModes> wanted);

  [[nodiscard]] bool has(automata::ComponentId component, automata::TransitionId transition) const;

 private:
  std::vector<std::vector<automata::TransitionId>> useful_;  ///< by component, ascending
};

}  // namespace rmpl::runtime
