// One step of the course of a plant.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/course.hpp"

#include <algorithm>
#include <utility>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Modes;

Course::Course(automata::PlantStep& step, const NominalGraph& graph, const Parts& parts)
    : step_(step), idle_(idle_action(step.plant())) {
  std::vector<bool> paid(parts.count());
  for (const ComponentId c : graph.components()) {
    const auto& modes = step.plant()[c].modes;
    const auto differs = [&](const automata::Mode& mode) { return mode.reward != modes.front().reward; };
    const bool pays = std::any_of(modes.begin(), modes.end(), differs);
    if (pays && !parts.controls(parts.of(c)).empty()) paid[parts.of(c)] = true;
  }
  for (const ComponentId c : graph.components()) {
    if (paid[parts.of(c)]) paid_.push_back(c);
  }
}

std::optional<Modes> Course::next(const Modes& modes, const std::optional<Modes>& expected) {
  return expected && *expected != modes ? expected : by_itself(modes, modes);
}

std::optional<Modes> Course::meanwhile(const Modes& modes, const Modes& expected) { return by_itself(modes, expected); }

/// What takes time stays where it is `awaited` elsewhere.
std::optional<Modes> Course::by_itself(const Modes& modes, const Modes& awaited) {
  Modes at_once = modes;
  Modes in_time = modes;
  for (const ComponentId c : paid_) {
    const automata::Enabled& enabled = step_.enabled(c, modes, idle_);
    const auto& transitions = step_.plant()[c].transitions;
    for (const automata::TransitionId id : enabled.untimed) at_once[c.index()] = transitions[id.index()].to;
    if (awaited[c.index()] != modes[c.index()]) continue;
    for (const automata::TransitionId id : enabled.timed) in_time[c.index()] = transitions[id.index()].to;
  }
  Modes& next = at_once != modes ? at_once : in_time;
  if (next == modes || !step_.possible(next)) return std::nullopt;
  return std::move(next);
}

}  // namespace rmpl::runtime
