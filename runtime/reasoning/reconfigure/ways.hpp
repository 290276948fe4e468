// Ways to bring about each nominal transition: its preconditions, with what they require of other components at hand.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "automata/state.hpp"
#include "runtime/reasoning/reconfigure/causal_order.hpp"
#include "runtime/reasoning/reconfigure/nominal_graph.hpp"

namespace rmpl::runtime {

/// A mode of a component, one of a requirement's values.
struct ModeRequirement {
  automata::ComponentId component;
  const Requirement* requirement;
  [[nodiscard]] bool met(const automata::Modes& modes) const {
    const auto& values = requirement->values;
    return std::binary_search(values.begin(), values.end(), automata::ValueId(modes[component.index()].index()));
  }
};

/// A precondition that goes upstream.
struct Way {
  const Precondition* precondition;
  std::vector<ModeRequirement> modes;  ///< in order of the precondition
};

/// Computed once: a planner looks at them in each step of each plan.
class Ways {
 public:
  Ways(const automata::Plant& plant, const NominalGraph& graph, const CausalOrder& order);

  /// Simplest preconditions first, as the transition has them.
  [[nodiscard]] const std::vector<Way>& of(automata::ComponentId component, const NominalTransition& transition) const {
    return ways_[component.index()][transition.id.index()];
  }

 private:
  std::vector<std::vector<std::vector<Way>>> ways_;  ///< per component, per transition
};

}  // namespace rmpl::runtime
