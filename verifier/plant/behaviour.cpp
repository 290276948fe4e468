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

Behaviours::Behaviours(automata::PlantStep& step, const TimeModel& time)
    : step_(step),
      time_(time),
      like_(step.plant()),
      readers_(step.plant().components.size() + step.plant().controls.size()) {
  const automata::Plant& plant = step.plant();
  const auto reads = [this](std::size_t position, ComponentId reader) {
    std::vector<ComponentId>& readers = readers_[position];
    if (readers.empty() || readers.back() != reader) readers.push_back(reader);
  };
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const ComponentId id(c);
    auto& modes = known_.emplace_back();
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      const automata::Support& support = step.support(id, ModeId(m));
      modes.push_back({{}, {plant, support}});
      for (const ComponentId read : support.components) reads(read.index(), id);
      for (const std::size_t control : support.controls) reads(plant.components.size() + control, id);
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

bool Behaviours::read(const Modes& modes, const ControlAction& action, std::vector<BehaviourId>& result) {
  result.resize(modes.size());
  like_.read(modes, seen_);
  const automata::AllEnabled* all = step_.consistent(seen_, action) ? nullptr : &step_.enabled(modes, action);
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const ComponentId id(c);
    if (all != nullptr) {
      result[c] = number(id, modes[c], (*all)[c]);
    } else {
      result[c] = look_up(id, modes[c], action);
    }
  }
  return all == nullptr;
}

void Behaviours::read(const Known& elsewhere, const Modes& modes, const ControlAction& action,
                      std::vector<BehaviourId>& result) {
  like_.read(modes, seen_);
  if (!step_.consistent(seen_, action)) {
    read(modes, action, result);
    return;
  }
  result = elsewhere.behaviours;
  const auto look_up_readers = [&](std::size_t position) {
    for (const ComponentId c : readers_[position]) result[c.index()] = look_up(c, modes[c.index()], action);
  };
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (modes[c] == elsewhere.modes[c]) continue;
    result[c] = look_up(ComponentId(c), modes[c], action);
    look_up_readers(c);
  }
  for (std::size_t i = 0; i < action.size(); ++i) {
    if (action[i] != elsewhere.action[i]) look_up_readers(modes.size() + i);
  }
}

BehaviourId Behaviours::look_up(ComponentId component, ModeId mode, const ControlAction& action) {
  Answers& known = known_[component.index()][mode.index()];
  if (const auto behaviour = known.decided.find(seen_, action)) return BehaviourId(*behaviour);
  return known.rest.find(seen_, action, [&] {
    Modes modes = seen_;
    modes[component.index()] = mode;
    const BehaviourId behaviour = number(component, mode, step_.enabled(component, modes, action));
    if (const auto why = reason(component, modes, action)) known.decided.add(seen_, action, *why, behaviour.value);
    return behaviour;
  });
}

/// What is enough to imply, or to refute, each guard of the mode; nothing where one is left open.
std::optional<std::vector<Premise>> Behaviours::reason(ComponentId component, const Modes& modes,
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

  // Controls first: what a command is not meant for is mostly decided by that alone.
  std::vector<Premise> result;
  std::vector<Premise> others;
  for (const Assignment& a : all) {
    if (const auto c = plant.component_of(a.variable)) {
      // Its own mode is what the answers are filed under.
      if (*c != component) others.push_back({c->value, a.value.value});
      continue;
    }
    const auto control = std::find_if(plant.controls.begin(), plant.controls.end(),
                                      [&](const automata::Control& one) { return one.variable == a.variable; });
    const auto position = plant.components.size() + static_cast<std::size_t>(control - plant.controls.begin());
    result.push_back({static_cast<std::uint32_t>(position), a.value.value});
  }
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

}  // namespace rmpl::verifier
