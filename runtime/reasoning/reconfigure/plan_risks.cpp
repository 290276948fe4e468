// Waits, and what goes on meanwhile.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/plan_risks.hpp"

#include <algorithm>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::TransitionId;

namespace {

/// Whether the component stays in the mode that it is in before this command, to which the plan took it, or on which
/// the goal depends.
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
    for (std::size_t c = 0; c < step.plant().components.size(); ++c) {
      const ComponentId component(c);
      if (!is_kept(plan, i, c, std::find(decisive.begin(), decisive.end(), component) != decisive.end())) continue;
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
