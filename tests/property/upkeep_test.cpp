// Switches, drivers and levels: a goal that can be reached and held is reached and held, and then all is at rest.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/seconds.hpp"

namespace rmpl::property {
namespace {

using automata::Assignment;
using automata::ControlAction;
using automata::Formula;
using automata::Plant;
using automata::PlantStep;
using automata::Ticks;
using automata::ValueId;
using automata::VariableId;
using Outcome = runtime::Reconfiguration::Outcome;

/// A switch with a command of its own. It may need an earlier one to be switched on, and trip without it; take its
/// time.
void add_switch(Plant& plant) {
  const std::size_t number = plant.components.size();
  const VariableId cmd = plant.variables.add({"cmd" + std::to_string(number), {"none", "on", "off"}});
  plant.controls.push_back({cmd, ValueId(0)});
  std::optional<VariableId> supply;
  if (number > 0 && chance(60)) supply = plant.components[up_to(0, number - 1)].mode;
  Formula on = is(cmd, ValueId(1));
  const bool supplied = supply && chance(70);
  if (supplied) on = automata::conjunction({on, is(*supply, ValueId(1))});
  automata::Component& part = add_part(plant, "switch" + std::to_string(number), {"off", "on", "booting"});
  if (chance(40)) {
    part.transitions = {move(0, 2, on), move(2, 1, automata::constant(true), some_seconds())};
  } else {
    part.transitions = {move(0, 1, on)};
  }
  Formula off = is(cmd, ValueId(2));
  if (supplied && chance(50)) off = automata::disjunction({off, is(*supply, ValueId(0))});
  part.transitions.push_back(move(1, 0, off));
}

/// What rises while a switch is on, and falls while it is off: nothing is irreversible.
void add_level(Plant& plant, std::size_t switches) {
  const std::size_t number = plant.components.size();
  const VariableId driver = plant.components[up_to(0, switches - 1)].mode;
  const std::vector<std::string> modes =
      chance(50) ? std::vector<std::string>{"low", "high"} : std::vector<std::string>{"low", "mid", "high"};
  automata::Component& part = add_part(plant, "level" + std::to_string(number), modes);
  for (std::size_t m = 0; m + 1 < modes.size(); ++m) {
    part.transitions.push_back(move(m, m + 1, is(driver, ValueId(1)), some_seconds()));
    part.transitions.push_back(move(m + 1, m, is(driver, ValueId(0)), some_seconds()));
  }
}

Plant draw_plant() {
  Plant plant;
  plant.name = "Workshop";
  const std::size_t switches = up_to(1, 3);
  for (std::size_t i = 0; i < switches; ++i) add_switch(plant);
  for (std::size_t i = up_to(0, 2); i > 0; --i) {
    add_level(plant, switches);
    // Two that are worth something may circle in an order of events that no plan foresees.
    if (i > 1) {
      for (automata::Mode& mode : plant.components.back().modes) mode.reward = 0;
    }
  }
  return plant;
}

/// One or two assignments to modes that are not initial, but to none that is only passed through.
std::vector<Assignment> draw_goal(const Plant& plant) {
  std::vector<Assignment> goal;
  for (std::size_t i = up_to(1, 2); i > 0; --i) {
    const automata::Component& part = pick(plant.components);
    goal.push_back({part.mode, ValueId(up_to(0, part.modes.size() - 1))});
  }
  return goal;
}

bool met(const Plant& plant, const Moment& moment, const std::vector<Assignment>& goal) {
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    for (const Assignment& a : goal) {
      if (a.variable == plant.components[c].mode && a.value.index() != moment.modes[c].index()) return false;
    }
  }
  return true;
}

/// Two letters a component, with the seconds where an exit is timed: thousands of moments are looked up, and built
/// without optimisation.
std::string key_of(const Plant& plant, const Moment& moment) {
  std::string key;
  for (std::size_t c = 0; c < moment.modes.size(); ++c) {
    const auto& transitions = plant.components[c].transitions;
    const bool timed = std::any_of(transitions.begin(), transitions.end(),
                                   [&](const auto& t) { return t.from == moment.modes[c] && t.timing; });
    key += static_cast<char>(moment.modes[c].value);
    key += static_cast<char>(timed ? moment.seconds[c] : 0);
  }
  return key;
}

/// Whether the goal holds from a moment on with nothing commanded. From a moment one run goes on, so that each is
/// looked at once.
class Held {
 public:
  Held(PlantStep& step, const std::vector<Assignment>& goal) : step_(step), goal_(goal) {}

  bool operator()(Moment moment) {
    const ControlAction idle = automata::idle_action(step_.plant());
    std::vector<bool*> way;
    bool held = true;
    while (held) {
      const auto [known, fresh] = known_.emplace(key_of(step_.plant(), moment), true);
      held = known->second && met(step_.plant(), moment, goal_);
      way.push_back(&known->second);
      if (!fresh) break;  // known, or round and round
      go_on(step_, moment, idle);
    }
    for (bool* const one : way) *one = held;
    return held;
  }

 private:
  PlantStep& step_;
  const std::vector<Assignment>& goal_;
  std::unordered_map<std::string, bool> known_;
};

/// None, or one command.
std::vector<ControlAction> some_actions(const Plant& plant) {
  std::vector<ControlAction> result{automata::idle_action(plant)};
  for (std::size_t control = 0; control < plant.controls.size(); ++control) {
    for (const std::size_t command : {1U, 2U}) {
      result.push_back(result.front());
      result.back()[control] = ValueId(command);
    }
  }
  return result;
}

/// Whether some commands, one at a time, lead to where the goal holds from then on: all moments are looked at.
bool can_be_held(PlantStep& step, const std::vector<Assignment>& goal) {
  const std::vector<ControlAction> actions = some_actions(step.plant());
  std::vector<Moment> open{at_rest(step.plant())};
  std::unordered_set<std::string> seen{key_of(step.plant(), open.front())};
  Held held(step, goal);
  while (!open.empty()) {
    const Moment from = open.back();
    open.pop_back();
    if (held(from)) return true;
    for (const ControlAction& action : actions) {
      Moment to = from;
      go_on(step, to, action);
      if (seen.insert(key_of(step.plant(), to)).second) open.push_back(std::move(to));
    }
  }
  return false;
}

/// Flies a goal from rest, which never has no plan, and tells where that ends: commands came to an end before half of
/// it.
Moment fly(PlantStep& step, const Formula& goal) {
  const auto reconfigurer = runtime::make_reconfigurer(step);
  Moment now = at_rest(step.plant());
  constexpr int cycles = 200;
  int last_command = 0;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const runtime::Reconfiguration answer = reconfigurer->next(now.modes, goal);
    RC_LOG() << cycle << ": " << rc::toString(now.modes) << " outcome " << static_cast<int>(answer.outcome) << " "
             << answer.reason << std::endl;
    RC_ASSERT(answer.outcome != Outcome::no_plan);
    if (answer.outcome == Outcome::command) last_command = cycle;
    go_on(step, now, answer.action);
  }
  RC_ASSERT(last_command < cycles / 2);
  return now;
}

RC_GTEST_PROP(Upkeep, WhatCanBeHeldIsHeld, ()) {
  const Plant plant = draw_plant();
  const std::vector<Assignment> goal = draw_goal(plant);
  RC_LOG() << rc::toString(Model{plant}) << std::endl << rc::toString(goal) << std::endl;
  PlantStep step(plant);
  RC_PRE(can_be_held(step, goal));
  RC_ASSERT(Held(step, goal)(fly(step, automata::conjunction_of(goal))));
}

RC_GTEST_PROP(Upkeep, CommandsComeToAnEndWhileAGoalWaitsForEver, ()) {
  Plant plant = draw_plant();
  automata::Component& late = add_part(plant, "late", {"coming", "there"});
  late.transitions.push_back(
      move(0, 1, automata::constant(true), automata::Timing{Ticks::of_seconds(1), Ticks::infinite(), {}}));
  const Formula goal = is(late.mode, ValueId(1));
  RC_LOG() << rc::toString(Model{plant}) << std::endl;
  PlantStep step(plant);
  fly(step, goal);
}

}  // namespace
}  // namespace rmpl::property
