// Finding: guards that begin to hold when the clock that their time bounds read has been running.
//
// A clock runs from when its mode was entered. A delay that begins with its guard needs a guard that holds by then.
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/findings.hpp"
#include "compiler/lint/plant/nominal.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::Formula;
using automata::Support;
using automata::Transition;
using automata::TransitionId;
using automata::ValueId;

namespace {

class LateGuards {
 public:
  explicit LateGuards(PlantAnalysis& analysis) : analysis_(analysis) {}

  bool is_late(PlantTransition candidate) {
    const Component& component = analysis_.plant()[candidate.component];
    const Transition& own = component.transitions[candidate.transition.index()];
    const Support support = analysis_.locality().support_of(own.guard);
    if (support.reads(candidate.component)) return false;
    return support.controls.empty() ? waits_for_others(candidate.component, own, support)
                                    : waits_for_command(component, own, support);
  }

 private:
  /// Whether the guard, which reads a command, can never hold while none is given: commands are given for a step.
  bool waits_for_command(const Component& component, const Transition& own, const Support& support) {
    const std::vector<Assignment> idle = in_idle(component, own, support);
    return analysis_.questions().possible(idle) && !analysis_.questions().possible(idle, own.guard);
  }

  /// Whether the guard, which reads none, never holds at the start, nor where the mode is about to be entered.
  bool waits_for_others(ComponentId c, const Transition& own, const Support& support) {
    const Component& component = analysis_.plant()[c];
    const bool starts = analysis_.reach().initial[c.index()][own.from.index()];
    const Assignment here{component.mode, ValueId(own.from.index())};
    if (starts && analysis_.questions().possible({&here, 1}, at_start(own.guard, support))) return false;
    for (std::size_t t = 0; t < component.transitions.size(); ++t) {
      const Transition& way = component.transitions[t];
      if (way.to != own.from || way.from == own.from || !analysis_.can_happen({c, TransitionId(t)})) continue;
      const Assignment before{component.mode, ValueId(way.from.index())};
      if (analysis_.questions().possible({&before, 1}, automata::conjunction({way.guard, own.guard}))) return false;
    }
    return true;
  }

  /// The mode that the transition leaves, and no command that its guard depends on.
  [[nodiscard]] std::vector<Assignment> in_idle(const Component& component, const Transition& own,
                                                const Support& support) const {
    std::vector<Assignment> result{{component.mode, ValueId(own.from.index())}};
    for (const std::size_t control : support.controls) {
      const automata::Control& read = analysis_.plant().controls[control];
      result.push_back({read.variable, read.idle});
    }
    return result;
  }

  /// The guard, and that the components it depends on are in initial modes.
  [[nodiscard]] Formula at_start(const Formula& guard, const Support& support) const {
    std::vector<Formula> result{guard};
    for (const ComponentId read : support.components) {
      const std::vector<bool>& initial = analysis_.reach().initial[read.index()];
      std::vector<ValueId> modes;
      for (std::size_t m = 0; m < initial.size(); ++m) {
        if (initial[m]) modes.emplace_back(m);
      }
      result.push_back(member(analysis_.plant()[read].mode, std::move(modes)));
    }
    return automata::conjunction(std::move(result));
  }

  PlantAnalysis& analysis_;
};

}  // namespace

std::vector<PlantTransition> find_late_guards(PlantAnalysis& analysis) {
  LateGuards guards(analysis);
  return nominal_where(analysis, [&](const Component&, const Transition& own, PlantTransition candidate) {
    const bool bounded = own.timing && !own.timing->upper.is_infinite() && own.timing->upper > automata::Ticks{};
    return bounded && !own.guard.is_true() && own.from != own.to && guards.is_late(candidate);
  });
}

}  // namespace rmpl::compiler
