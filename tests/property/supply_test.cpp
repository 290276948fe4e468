// Chains of supply: what is done for reward while something waits does not take away what it waits on.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"

namespace rmpl::property {
namespace {

using automata::ComponentId;
using automata::Formula;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::Ticks;
using automata::Timing;
using automata::ValueId;
using automata::VariableId;

constexpr std::int64_t most_seconds = 5;

Timing some_seconds() {
  const auto lower = static_cast<std::int64_t>(up_to(1, most_seconds - 1));
  return {Ticks::of_seconds(lower), Ticks::of_seconds(lower + 1), {}};
}

automata::Transition move(std::size_t from, std::size_t to, Formula guard, std::optional<Timing> timing = {}) {
  return {ModeId(from), ModeId(to), std::move(guard), timing, {}, 0, {}};
}

/// A component with these modes, a reward on one of them now and then.
automata::Component& add_component(Plant& plant, const std::string& name, const std::vector<std::string>& modes) {
  const VariableId mode = plant.variables.add({name, modes});
  automata::Component component{name, name, mode, {}, std::vector<double>(modes.size()), {}, {}};
  component.initial[0] = 1;
  for (const std::string& m : modes) component.modes.push_back({m, false, automata::constant(true), 0, {}});
  if (chance(50)) component.modes[up_to(0, modes.size() - 1)].reward = chance(50) ? 1 : -1;
  return plant.components.emplace_back(std::move(component));
}

/// A switch, links that follow it, and a load that takes its time with what the last one brings.
Plant draw_chain() {
  Plant plant;
  plant.name = "Chain";
  const VariableId cmd = plant.variables.add({"cmd", {"none", "on", "off"}});
  plant.controls.push_back({cmd, ValueId(0)});
  automata::Component& first = add_component(plant, "switch", {"off", "on"});
  first.transitions = {move(0, 1, is(cmd, ValueId(1))), move(1, 0, is(cmd, ValueId(2)))};
  VariableId supply = first.mode;
  for (std::size_t i = up_to(0, 3); i > 0; --i) {
    automata::Component& link = add_component(plant, "link" + std::to_string(i), {"still", "running"});
    const auto falls = chance(50) ? std::optional(some_seconds()) : std::nullopt;
    const auto rises = chance(30) ? std::optional(some_seconds()) : std::nullopt;
    link.transitions = {move(0, 1, is(supply, ValueId(1)), rises), move(1, 0, is(supply, ValueId(0)), falls)};
    supply = link.mode;
  }
  automata::Component& load = add_component(plant, "load", {"warm", "cooling", "cold"});
  load.transitions = {move(0, 1, is(supply, ValueId(1))), move(1, 0, is(supply, ValueId(0))),
                      move(1, 2, is(supply, ValueId(1)), some_seconds())};
  return plant;
}

/// One cycle of a second: each component takes what needs no time at once, what is timed after its upper bound.
void go_on(automata::PlantStep& step, Modes& modes, std::vector<std::int64_t>& seconds,
           const automata::ControlAction& action) {
  Modes after = modes;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const auto& enabled = step.enabled(ComponentId(c), modes, action);
    const auto& transitions = step.plant().components[c].transitions;
    ++seconds[c];
    std::optional<ModeId> next;
    for (const automata::TransitionId t : enabled.timed) {
      if (Ticks::of_seconds(seconds[c]) >= transitions[t.index()].timing->upper) next = transitions[t.index()].to;
    }
    for (const automata::TransitionId t : enabled.untimed) next = transitions[t.index()].to;
    if (next && *next != modes[c]) {
      after[c] = *next;
      seconds[c] = 0;
    }
  }
  modes = std::move(after);
}

RC_GTEST_PROP(Supply, WhatIsWaitedForComes, ()) {
  const Plant plant = draw_chain();
  RC_LOG() << rc::toString(Model{plant}) << std::endl;
  automata::PlantStep step(plant);
  const auto reconfigurer = runtime::make_reconfigurer(step);
  const Formula goal = is(plant.components.back().mode, ValueId(2));
  Modes modes(plant.components.size(), ModeId(0));
  std::vector<std::int64_t> seconds(modes.size());
  std::size_t commands = 0;
  for (int cycle = 0; cycle < 100 && modes.back() != ModeId(2); ++cycle) {
    const runtime::Reconfiguration answer = reconfigurer->next(modes, goal);
    RC_ASSERT(answer.outcome != runtime::Reconfiguration::Outcome::no_plan);
    commands += answer.outcome == runtime::Reconfiguration::Outcome::command ? 1 : 0;
    go_on(step, modes, seconds, answer.action);
  }
  RC_ASSERT(modes.back() == ModeId(2));
  RC_ASSERT(commands == 1U);
}

}  // namespace
}  // namespace rmpl::property
