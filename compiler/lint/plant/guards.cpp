// Finding: guards that never hold.
// SPDX-License-Identifier: MIT
#include "automata/step/transition_rules.hpp"
#include "compiler/lint/plant/findings.hpp"

namespace rmpl::compiler {

using automata::ComponentId;
using automata::TransitionId;

std::vector<PlantTransition> find_impossible_guards(const PlantAnalysis& analysis) {
  std::vector<PlantTransition> found;
  const automata::Plant& plant = analysis.plant();
  const Reach& reach = analysis.reach();
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const auto& transitions = plant.components[c].transitions;
    for (std::size_t t = 0; t < transitions.size(); ++t) {
      if (!reach.reached[c][transitions[t].from.index()] || !can_ever_be_taken(transitions[t])) continue;
      if (reach.guards[c][t].verdict == Implied::Verdict::no) found.push_back({ComponentId(c), TransitionId(t)});
    }
  }
  return found;
}

}  // namespace rmpl::compiler
