// Transitions that are enabled together.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "compiler/lint/plant/analysis.hpp"

namespace rmpl::compiler {

/// Whether some transition out of the same mode that leads elsewhere, and that `counts`, may ever be enabled together
/// with one, where modes and command imply `where` too; where that is not decided, it may.
template <class Counts>
bool may_be_beside(PlantAnalysis& analysis, PlantTransition one, const Counts& counts,
                   const automata::Formula& where = automata::constant(true)) {
  const automata::Component& component = analysis.plant()[one.component];
  const automata::Transition& own = component.transitions[one.transition.index()];
  for (std::size_t t = 0; t < component.transitions.size(); ++t) {
    const automata::Transition& other = component.transitions[t];
    if (other.from != own.from || other.to == own.to || !counts(other)) continue;
    if (!analysis.can_happen({one.component, automata::TransitionId(t)})) continue;
    const std::array guards{&own.guard, &other.guard, &where};
    const Implied both = analysis.questions().implied(one.component, own.from, guards);
    if (both.verdict != Implied::Verdict::no) return true;
  }
  return false;
}

}  // namespace rmpl::compiler
