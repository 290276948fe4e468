// Finding: nominal transitions that are never taken, as something goes before them wherever their guards hold.
//
// One untimed transition has to be implied by the guard by itself: that a disjunction is implied does not mean that one
// of its members is (semantics 3).
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/findings.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::Formula;
using automata::Transition;
using automata::TransitionId;
using automata::ValueId;

namespace {

class Shadows {
 public:
  Shadows(PlantAnalysis& analysis, ComponentId id) : analysis_(analysis), component_(analysis.plant()[id]), id_(id) {}

  void find(std::vector<Shadow>& found) {
    for (std::size_t t = 0; t < component_.transitions.size(); ++t) {
      if (!matters(t) || component_.is_fault(component_.transitions[t])) continue;
      std::vector<TransitionId> by = forestalled_by(component_.transitions[t]);
      if (!by.empty()) found.push_back({id_, TransitionId(t), std::move(by)});
    }
  }

 private:
  [[nodiscard]] bool matters(std::size_t t) const { return analysis_.can_happen({id_, TransitionId(t)}); }

  std::vector<TransitionId> forestalled_by(const Transition& late) {
    std::vector<TransitionId> faults;
    double left = 1;
    for (std::size_t t = 0; t < component_.transitions.size(); ++t) {
      const Transition& early = component_.transitions[t];
      if (early.from != late.from || early.timing || !matters(t)) continue;
      const bool fault = component_.is_fault(early);
      if (fault ? early.weight.kind != automata::Weight::Kind::probability : !late.timing) continue;
      if (!always_with(late, early)) continue;
      if (!fault) return {TransitionId(t)};
      faults.emplace_back(t);
      left -= early.weight.value;
    }
    return left <= 0 ? faults : std::vector<TransitionId>{};
  }

  bool always_with(const Transition& late, const Transition& early) {
    if (early.guard.is_true() || early.guard == late.guard) return true;
    const Assignment mode{component_.mode, ValueId(late.from.index())};
    return !analysis_.questions().possible({&mode, 1}, automata::conjunction({late.guard, negation(early.guard)}));
  }

  PlantAnalysis& analysis_;
  const Component& component_;
  ComponentId id_;
};

}  // namespace

std::vector<Shadow> find_shadowed_transitions(PlantAnalysis& analysis) {
  std::vector<Shadow> found;
  for (std::size_t c = 0; c < analysis.plant().components.size(); ++c) Shadows(analysis, ComponentId(c)).find(found);
  return found;
}

}  // namespace rmpl::compiler
