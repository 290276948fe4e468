// Behaviours: what each component may do next.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/behaviour.hpp"

#include "verifier/behaviour/folds.hpp"
#include "verifier/behaviour/reasons.hpp"

namespace rmpl::verifier {

using automata::ComponentId;
using automata::ControlAction;
using automata::Enabled;
using automata::ModeId;
using automata::Modes;

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
      const automata::Support& support = step.commanded_support(id, ModeId(m));
      modes.push_back({{}, {plant, support}});
      for (const ComponentId read : support.components) reads(read.index(), id);
      for (const std::size_t control : support.controls) reads(plant.components.size() + control, id);
    }
  }
}

BehaviourId Behaviours::number(ModeId mode, std::vector<Choice> all, std::vector<Interval> pauses, bool restarts) {
  const auto [at, fresh] = numbers_.try_emplace({mode, all, pauses, restarts}, BehaviourId(table_.size()));
  if (!fresh) return at->second;
  Behaviour behaviour{std::move(all), std::move(pauses)};
  behaviour.faulty = without_nominal(behaviour.choices);
  behaviour.restarts = restarts;
  some_restart_ = some_restart_ || restarts;
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
  const bool restarts = automata::restarts(automaton, enabled) && step_.plant().has_timed_exit(component, mode);
  return number(mode, choices(automaton, mode, enabled, time_), waits(automaton, mode, enabled, time_), restarts);
}

BehaviourId Behaviours::folded(ModeId mode, BehaviourId id) {
  if (const auto known = folded_.find(id); known != folded_.end()) return known->second;
  const Behaviour& own = table_[id.index()];
  BehaviourId result = id;
  if (own.stays_until >= 0) {
    // Nothing untimed is enabled: what is nominal is staying, and the exit that is not seen.
    std::vector<Choice> choices;
    for (const Choice& choice : own.choices) {
      if (choice.faults == 0 && choice.mode != mode) continue;
      choices.push_back(choice.faults == 0 ? Choice{mode, 0, {}} : choice);
    }
    result = number(mode, std::move(choices), {Interval{}}, false);
  }
  folded_.emplace(id, result);
  return result;
}

void Behaviours::fold(const Modes& modes, std::vector<BehaviourId>& result) {
  if (folds_ == nullptr) return;
  for (const ComponentId c : folds_->in(modes)) result[c.index()] = folded(modes[c.index()], result[c.index()]);
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
  fold(modes, result);
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
  if (folds_ != nullptr) {
    for (const ComponentId c : folds_->in(elsewhere.modes)) {
      result[c.index()] = look_up(c, modes[c.index()], action);
    }
  }
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
  fold(modes, result);
}

BehaviourId Behaviours::look_up(ComponentId component, ModeId mode, const ControlAction& action) {
  Answers& known = known_[component.index()][mode.index()];
  if (const auto behaviour = known.decided.find(seen_, action)) return BehaviourId(*behaviour);
  return known.rest.find(seen_, action, [&] {
    Modes modes = seen_;
    modes[component.index()] = mode;
    const BehaviourId behaviour = number(component, mode, step_.enabled(component, modes, action));
    if (const auto why = reason(step_, component, modes, action))
      known.decided.add(seen_, action, *why, behaviour.value);
    return behaviour;
  });
}

}  // namespace rmpl::verifier
