// Waits, and what goes on meanwhile.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/plan_risks.hpp"

#include <algorithm>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::TransitionId;

namespace {

/// Whether the plan took the component to the mode that it is in before this command, and leaves it there.
bool is_kept(const Plan& plan, std::size_t from, std::size_t component) {
  const automata::ModeId mode = plan.states[from][component];
  return plan.states.front()[component] != mode &&
         std::all_of(plan.states.begin() + static_cast<std::ptrdiff_t>(from), plan.states.end(),
                     [&](const automata::Modes& modes) { return modes[component] == mode; });
}

}  // namespace

std::vector<PlanRisk> risks_of(const Plan& plan, automata::PlantStep& step) {
  std::vector<PlanRisk> risks;
  const automata::ControlAction idle = idle_action(step.plant());
  for (std::size_t i = 0; i < plan.commands.size(); ++i) {
    if (plan.commands[i] != idle) continue;
    for (std::size_t c = 0; c < step.plant().components.size(); ++c) {
      if (!is_kept(plan, i, c)) continue;
      const ComponentId component(c);
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
