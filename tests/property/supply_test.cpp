// Chains of supply: what is done for reward while something waits does not take away what it waits on.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/seconds.hpp"

namespace rmpl::property {
namespace {

using automata::Formula;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::ValueId;
using automata::VariableId;

/// A switch, links that follow it, and a load that takes its time with what the last one brings. Without rewards, for
/// which the switch might go off while the links coast.
Plant draw_chain() {
  Plant plant;
  plant.name = "Chain";
  const VariableId cmd = plant.variables.add({"cmd", {"none", "on", "off"}});
  plant.controls.push_back({cmd, ValueId(0)});
  automata::Component& first = add_part(plant, "switch", {"off", "on"});
  first.transitions = {move(0, 1, is(cmd, ValueId(1))), move(1, 0, is(cmd, ValueId(2)))};
  VariableId supply = first.mode;
  for (std::size_t i = up_to(0, 3); i > 0; --i) {
    automata::Component& link = add_part(plant, "link" + std::to_string(i), {"still", "running"});
    const auto falls = chance(50) ? std::optional(some_seconds()) : std::nullopt;
    const auto rises = chance(30) ? std::optional(some_seconds()) : std::nullopt;
    link.transitions = {move(0, 1, is(supply, ValueId(1)), rises), move(1, 0, is(supply, ValueId(0)), falls)};
    supply = link.mode;
  }
  automata::Component& load = add_part(plant, "load", {"warm", "cooling", "cold"});
  load.transitions = {move(0, 1, is(supply, ValueId(1))), move(1, 0, is(supply, ValueId(0))),
                      move(1, 2, is(supply, ValueId(1)), some_seconds())};
  for (automata::Component& component : plant.components) {
    for (automata::Mode& mode : component.modes) mode.reward = 0;
  }
  return plant;
}

/// A switch that is on, and loads behind it that step up and down by commands of their own, and fall at once without
/// it. Without rewards, which might be worth a detour.
Plant draw_loads() {
  Plant plant;
  plant.name = "Loads";
  const auto control = [&](const std::string& name, std::vector<std::string> values) {
    const VariableId cmd = plant.variables.add({name, std::move(values)});
    plant.controls.push_back({cmd, ValueId(0)});
    return cmd;
  };
  const VariableId cmd = control("switch.cmd", {"none", "on", "off"});
  automata::Component& bus = add_part(plant, "switch", {"off", "on"});
  bus.transitions = {move(0, 1, is(cmd, ValueId(1))), move(1, 0, is(cmd, ValueId(2)))};
  for (automata::Mode& mode : bus.modes) mode.reward = 0;
  const VariableId supply = bus.mode;
  for (std::size_t i = up_to(1, 3); i > 0; --i) {
    const std::string name = "load" + std::to_string(i);
    const VariableId own = control(name + ".cmd", {"none", "up", "down"});
    automata::Component& load = add_part(plant, name, {"off", "ready", "running"});
    for (std::size_t m = 0; m < 2; ++m) {
      const bool powered = chance(70);
      const auto with = [&](Formula guard) {
        return powered ? automata::conjunction({std::move(guard), is(supply, ValueId(1))}) : guard;
      };
      load.transitions.push_back(move(m, m + 1, with(is(own, ValueId(1)))));
      load.transitions.push_back(move(m + 1, m, with(is(own, ValueId(2)))));
      if (chance(60)) load.transitions.push_back(move(m + 1, 0, is(supply, ValueId(0))));
    }
    for (automata::Mode& mode : load.modes) mode.reward = 0;
    std::shuffle(load.transitions.begin(), load.transitions.end(), std::minstd_rand(up_to(0, 1000)));
  }
  return plant;
}

/// Its own commands take no more steps than to switch off all that hangs on the same supply.
RC_GTEST_PROP(Supply, NoOtherLoadIsLostForOne, ()) {
  const Plant plant = draw_loads();
  RC_LOG() << rc::toString(Model{plant}) << std::endl;
  automata::PlantStep step(plant);
  const auto reconfigurer = runtime::make_reconfigurer(step);
  Moment now = at_rest(plant);
  now.modes.front() = ModeId(1);
  for (std::size_t c = 1; c < now.modes.size(); ++c) now.modes[c] = ModeId(up_to(0, 2));
  Modes end = now.modes;
  end.back() = ModeId(up_to(0, 2));
  const Formula goal = is(plant.components.back().mode, ValueId(end.back().index()));
  for (int cycle = 0; cycle < 10 && now.modes != end; ++cycle) {
    const runtime::Reconfiguration answer = reconfigurer->next(now.modes, goal);
    RC_ASSERT(answer.outcome == runtime::Reconfiguration::Outcome::command);
    go_on(step, now, answer.action);
  }
  RC_ASSERT(now.modes == end);
}

RC_GTEST_PROP(Supply, WhatIsWaitedForComes, ()) {
  const Plant plant = draw_chain();
  RC_LOG() << rc::toString(Model{plant}) << std::endl;
  automata::PlantStep step(plant);
  const auto reconfigurer = runtime::make_reconfigurer(step, nullptr, automata::Ticks::of_seconds(1));
  const Formula goal = is(plant.components.back().mode, ValueId(2));
  Moment now = at_rest(plant);
  std::size_t commands = 0;
  runtime::StrategyPosition position;
  for (int cycle = 0; cycle < 100 && now.modes.back() != ModeId(2); ++cycle) {
    const runtime::Reconfiguration answer = reconfigurer->go_on(now.modes, goal, position);
    RC_ASSERT(answer.outcome != runtime::Reconfiguration::Outcome::no_plan);
    commands += answer.outcome == runtime::Reconfiguration::Outcome::command ? 1 : 0;
    go_on(step, now, answer.action);
    position = position_after(answer, now.modes);
  }
  RC_ASSERT(now.modes.back() == ModeId(2));
  RC_ASSERT(commands == 1U);
}

}  // namespace
}  // namespace rmpl::property
