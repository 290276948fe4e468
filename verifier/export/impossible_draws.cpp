// SPDX-License-Identifier: MIT
#include "verifier/export/impossible_draws.hpp"

#include <algorithm>
#include <set>

#include "automata/assignment_text.hpp"
#include "base/error.hpp"
#include "base/product.hpp"

namespace rmpl::verifier {

using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::Plant;

namespace {

/// The components that modes which contradict each other can depend on.
std::vector<ComponentId> components_that_exclude(const Plant& plant, Influence& influence) {
  std::set<ComponentId> found;
  std::vector<ComponentId> open;
  const auto add = [&](const std::vector<ComponentId>& components) {
    for (const ComponentId c : components) {
      if (found.insert(c).second) open.push_back(c);
    }
  };
  for (const automata::Support& support : influence.exclusions()) add(support.components);
  while (!open.empty()) {
    const ComponentId component = open.back();
    open.pop_back();
    for (std::size_t m = 0; m < plant[component].modes.size(); ++m) {
      add(influence.support_of(component, ModeId(m)).components);
    }
  }
  return {found.begin(), found.end()};
}

std::vector<ModeId> targets(const automata::Component& component, ModeId mode, const automata::Enabled& enabled) {
  std::set<ModeId> result;
  if (enabled.untimed.empty()) result.insert(mode);
  const auto add = [&](automata::TransitionId t) { result.insert(component.transitions[t.index()].to); };
  std::for_each(enabled.faults.begin(), enabled.faults.end(), add);
  std::for_each(enabled.untimed.begin(), enabled.untimed.end(), add);
  std::for_each(enabled.timed.begin(), enabled.timed.end(), add);
  return {result.begin(), result.end()};
}

}  // namespace

std::string describe(const Plant& plant, const ControlAction& action) {
  const std::string text = to_text(plant.variables, automata::commanded(plant, action));
  return text.empty() ? "all controls idle" : text;
}

void refuse_impossible_draws(automata::PlantStep& step, Influence& influence,
                             const std::vector<std::vector<ModeId>>& initial, const std::vector<ControlAction>& actions,
                             Meter& meter) {
  if (influence.exclusions().empty()) return;
  const Plant& plant = step.plant();
  const auto text_of = [&](const Modes& modes) {
    return to_text(plant.variables, automata::assignments_of(plant, modes));
  };
  const std::vector<ComponentId> asked = components_that_exclude(plant, influence);
  std::set<Modes> seen;
  std::vector<Modes> queue;
  const auto add = [&](const Modes& modes) {
    meter.poll();
    if (!seen.insert(modes).second) return;
    if (!step.possible(modes)) {
      throw base::InputError("prism cannot say that modes are impossible, and these may be drawn: " + text_of(modes));
    }
    meter.count_state();
    queue.push_back(modes);
  };
  std::vector<std::vector<ModeId>> lists;
  for (const std::vector<ModeId>& modes : initial) lists.push_back({modes.front()});
  for (const ComponentId c : asked) lists[c.index()] = initial[c.index()];
  base::for_each_combination(lists, add);
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const Modes modes = queue[next];
    for (const ControlAction& action : actions) {
      if (!step.consistent(modes, action)) {
        throw base::InputError("prism cannot say what follows where the command " + describe(plant, action) +
                               " contradicts the modes: " + text_of(modes));
      }
      const automata::AllEnabled enabled = step.enabled(modes, action);
      for (const ComponentId c : asked) {
        lists[c.index()] = targets(plant[c], modes[c.index()], enabled[c.index()]);
      }
      base::for_each_combination(lists, add);
    }
  }
}

}  // namespace rmpl::verifier
