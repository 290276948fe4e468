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

std::vector<Modes> Course::next(const Modes& modes, const std::optional<Modes>& expected) {
  return expected && *expected != modes ? std::vector<Modes>{*expected} : by_itself(modes, modes);
}

std::vector<Modes> Course::meanwhile(const Modes& modes, const Modes& expected) { return by_itself(modes, expected); }

/// What takes time stays where it is `awaited` elsewhere.
std::vector<Modes> Course::by_itself(const Modes& modes, const Modes& awaited) {
  Modes at_once = modes;
  Modes in_time = modes;
  std::vector<Modes> one_by_one;
  for (const ComponentId c : paid_) {
    const automata::Enabled& enabled = step_.enabled(c, modes, idle_);
    const auto& transitions = step_.plant()[c].transitions;
    for (const automata::TransitionId id : enabled.untimed) at_once[c.index()] = transitions[id.index()].to;
    if (awaited[c.index()] != modes[c.index()]) continue;
    for (const automata::TransitionId id : enabled.timed) {
      in_time[c.index()] = transitions[id.index()].to;
      one_by_one.push_back(modes);
      one_by_one.back()[c.index()] = in_time[c.index()];
    }
  }
  std::vector<Modes> result;
  const auto add = [&](Modes next) {
    const bool known = std::find(result.begin(), result.end(), next) != result.end();
    if (next != modes && !known && step_.possible(next)) result.push_back(std::move(next));
  };
  if (at_once != modes) {
    add(std::move(at_once));
    return result;
  }
  add(std::move(in_time));
  for (Modes& next : one_by_one) add(std::move(next));
  return result;
}

}  // namespace rmpl::runtime
