// Behaviours: what each component may do next.
// SPDX-License-Identifier: MIT
#include "verifier/plant/behaviour.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::ComponentId;
using automata::ControlAction;
using automata::Enabled;
using automata::ModeId;
using automata::Modes;
using automata::Theory;
using automata::TransitionId;

namespace {

/// So many reasons of one component in one mode are looked through, one by one.
constexpr std::size_t most_reasons = 512;

}  // namespace

Behaviours::Behaviours(automata::PlantStep& step, const TimeModel& time) : step_(step), time_(time) {
  const automata::Plant& plant = step.plant();
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    auto& modes = known_.emplace_back();
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      modes.push_back({{}, {plant, step.support(ComponentId(c), ModeId(m))}});
    }
  }
}

BehaviourId Behaviours::number(ModeId mode, std::vector<Choice> all, std::vector<Interval> pauses) {
  const auto [at, fresh] = numbers_.try_emplace({mode, all, pauses}, BehaviourId(table_.size()));
  if (!fresh) return at->second;
  Behaviour behaviour{std::move(all), std::move(pauses)};
  behaviour.faulty = without_nominal(behaviour.choices);
  for (const Choice& choice : behaviour.choices) {
    if (choice.mode != mode) behaviour.changes = true;
    if (choice.mode == mode && choice.faults == 0 && choice.clock.lower <= 0)
      behaviour.stays_until = choice.clock.upper;
  }
  table_.push_back(std::move(behaviour));
  return at->second;
}

BehaviourId Behaviours::number(ComponentId component, ModeId mode, const Enabled& enabled) {
  const automata::Component& automaton = step_.plant()[component];
  return number(mode, choices(automaton, mode, enabled, time_), waits(automaton, mode, enabled, time_));
}

void Behaviours::read(const Modes& modes, const ControlAction& action, std::vector<BehaviourId>& result) {
  result.resize(modes.size());
  const automata::AllEnabled* all = step_.consistent(modes, action) ? nullptr : &step_.enabled(modes, action);
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const ComponentId id(c);
    if (all != nullptr) {
      result[c] = number(id, modes[c], (*all)[c]);
    } else {
      result[c] = look_up(id, modes, action);
    }
  }
}

BehaviourId Behaviours::look_up(ComponentId component, const Modes& modes, const ControlAction& action) {
  Known& known = known_[component.index()][modes[component.index()].index()];
  const auto fits = [&](const Reason& r) {
    return std::all_of(r.controls.begin(), r.controls.end(),
                       [&](const Premise& p) { return action[p.position].value == p.value; }) &&
           std::all_of(r.modes.begin(), r.modes.end(),
                       [&](const Premise& p) { return modes[p.position].value == p.value; });
  };
  const auto reason = std::find_if(known.reasons.begin(), known.reasons.end(), fits);
  if (reason != known.reasons.end()) {
    const BehaviourId behaviour = reason->behaviour;
    // What is asked for often comes to be found soon.
    if (reason != known.reasons.begin()) std::iter_swap(reason, reason - 1);
    return behaviour;
  }
  return known.rest.find(modes, action, [&] {
    const BehaviourId behaviour = number(component, modes[component.index()], step_.enabled(component, modes, action));
    if (known.reasons.size() < most_reasons) {
      if (auto why = this->reason(component, modes, action)) {
        why->behaviour = behaviour;
        known.reasons.push_back(std::move(*why));
      }
    }
    return behaviour;
  });
}

/// What is enough to imply, or to refute, each guard of the mode; nothing where one is left open.
std::optional<Behaviours::Reason> Behaviours::reason(ComponentId component, const Modes& modes,
                                                     const ControlAction& action) {
  const automata::Plant& plant = step_.plant();
  const ModeId mode = modes[component.index()];
  const automata::Support& support = step_.support(component, mode);
  std::vector<Assignment> store;
  for (const ComponentId c : support.components) {
    store.push_back({plant[c].mode, automata::ValueId(modes[c.index()].index())});
  }
  for (const std::size_t i : support.controls) store.push_back({plant.controls[i].variable, action[i]});

  std::vector<Theory::Handle> guards;
  for (std::size_t t = 0; t < plant[component].transitions.size(); ++t) {
    if (plant[component].transitions[t].from == mode) guards.push_back(step_.guard(component, TransitionId(t)));
  }
  Theory& theory = step_.theory();
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

  Reason result{{}, {}, {}};
  for (const Assignment& a : all) {
    if (const auto c = plant.component_of(a.variable)) {
      // Its own mode is what the reasons are filed under.
      if (*c != component) result.modes.push_back({c->value, a.value.value});
      continue;
    }
    const auto control = std::find_if(plant.controls.begin(), plant.controls.end(),
                                      [&](const automata::Control& one) { return one.variable == a.variable; });
    result.controls.push_back({static_cast<std::uint32_t>(control - plant.controls.begin()), a.value.value});
  }
  return result;
}

}  // namespace rmpl::verifier
