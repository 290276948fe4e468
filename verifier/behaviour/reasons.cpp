// Reasons.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/reasons.hpp"

#include <algorithm>

#include "automata/controls.hpp"
#include "base/check.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::Theory;
using automata::TransitionId;

std::optional<std::vector<Premise>> reason(automata::PlantStep& step, ComponentId component, const Modes& modes,
                                           const ControlAction& action, const std::vector<ComponentId>& unknown) {
  const automata::Plant& plant = step.plant();
  const ModeId mode = modes[component.index()];
  const automata::Support& support = step.support(component, mode);
  std::vector<Assignment> store;
  for (const ComponentId c : support.components) {
    if (std::binary_search(unknown.begin(), unknown.end(), c)) continue;
    store.push_back({plant[c].mode, automata::ValueId(modes[c.index()].index())});
  }
  for (const std::size_t i : support.controls) store.push_back({plant.controls[i].variable, action[i]});

  std::vector<Theory::Handle> guards;
  for (std::size_t t = 0; t < plant[component].transitions.size(); ++t) {
    if (plant[component].transitions[t].from == mode) guards.push_back(step.guard(component, TransitionId(t)));
  }
  Theory& theory = step.theory();
  std::vector<Assignment> all;
  while (true) {
    // What decides one guard mostly decides others as well.
    [[maybe_unused]] const bool consistent = theory.consistent(all);
    CHECK(consistent && "what contradicts itself enables everything");
    std::erase_if(guards, [&](Theory::Handle g) { return theory.known_to_follow(g) || theory.known_to_fail(g); });
    if (guards.empty()) break;
    if (!theory.entails(store, guards.front()) && theory.allows(store, guards.front())) return std::nullopt;
    const std::vector<Assignment>& core = theory.conflict();
    guards.erase(guards.begin());
    all.insert(all.end(), core.begin(), core.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }

  // Controls first: what a command is not meant for is mostly decided by that alone.
  std::vector<Premise> result;
  std::vector<Premise> others;
  for (const Assignment& a : all) {
    if (const auto c = plant.component_of(a.variable)) {
      // Its own mode is what the answers are filed under.
      if (*c != component) others.push_back({c->value, a.value.value});
      continue;
    }
    const std::size_t position = plant.components.size() + *automata::control_of(plant, a.variable);
    result.push_back({static_cast<std::uint32_t>(position), a.value.value});
  }
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

}  // namespace rmpl::verifier
