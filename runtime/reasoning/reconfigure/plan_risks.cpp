// Waits, and what goes on meanwhile.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/plan_risks.hpp"

#include <algorithm>
#include <set>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::TransitionId;

namespace {

/// The transitions by which a component may have gone on in a step of the plan.
std::vector<const automata::Transition*> taken(const Plan& plan, std::size_t step, const automata::Component& component,
                                               std::size_t position) {
  std::vector<const automata::Transition*> result;
  const automata::ModeId from = plan.states[step][position];
  const automata::ModeId to = plan.states[step + 1][position];
  for (const automata::Transition& t : component.transitions) {
    if (from != to && t.from == from && t.to == to && !component.is_fault(t)) result.push_back(&t);
  }
  return result;
}

/// From a step on that waits for what takes time: the components on whose modes it rests, and all that is still to
/// come.
std::set<ComponentId> relied_on(const Plan& plan, std::size_t from, automata::PlantStep& step) {
  std::set<ComponentId> result;
  bool takes_time = false;
  for (std::size_t i = from; i < plan.commands.size(); ++i) {
    for (std::size_t c = 0; c < step.plant().components.size(); ++c) {
      for (const automata::Transition* t : taken(plan, i, step.plant().components[c], c)) {
        takes_time = takes_time || (i == from && t->timing);
        if (t->guard.is_true()) continue;
        const auto& support = step.locality().support_of(t->guard).components;
        result.insert(support.begin(), support.end());
      }
    }
  }
  return takes_time ? result : std::set<ComponentId>{};
}

/// Whether the component stays in the mode that it is in before this command, to which the plan took it, or on which
/// the goal or the rest of the plan depends.
bool is_kept(const Plan& plan, std::size_t from, std::size_t component, bool asked) {
  const automata::ModeId mode = plan.states[from][component];
  return (asked || plan.states.front()[component] != mode) &&
         std::all_of(plan.states.begin() + static_cast<std::ptrdiff_t>(from), plan.states.end(),
                     [&](const automata::Modes& modes) { return modes[component] == mode; });
}

}  // namespace

std::vector<PlanRisk> risks_of(const Plan& plan, automata::PlantStep& step, const automata::Formula& goal) {
  std::vector<PlanRisk> risks;
  const std::vector<ComponentId> decisive = step.locality().support_of(goal).components;
  const automata::ControlAction idle = idle_action(step.plant());
  for (std::size_t i = 0; i < plan.commands.size(); ++i) {
    if (plan.commands[i] != idle) continue;
    const std::set<ComponentId> relied = relied_on(plan, i, step);
    for (std::size_t c = 0; c < step.plant().components.size(); ++c) {
      const ComponentId component(c);
      const bool asked =
          relied.contains(component) || std::find(decisive.begin(), decisive.end(), component) != decisive.end();
      if (!is_kept(plan, i, c, asked)) continue;
      const auto& timed = step.enabled(component, plan.states[i], idle).timed;
      const auto leaving = std::find_if(timed.begin(), timed.end(), [&](TransitionId id) {
        const automata::Transition& t = step.plant()[component].transitions[id.index()];
        return t.to != t.from && !t.timing->upper.is_infinite();
      });
      if (leaving != timed.end()) risks.push_back({i, {component, *leaving}});
    }
  }
  return risks;
}

}  // namespace rmpl::runtime
