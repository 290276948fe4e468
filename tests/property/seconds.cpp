// SPDX-License-Identifier: MIT
#include "tests/property/seconds.hpp"

#include <algorithm>

#include "tests/property/draw.hpp"

namespace rmpl::property {

using automata::ComponentId;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::Ticks;

automata::Timing some_seconds() {
  const auto lower = static_cast<std::int64_t>(up_to(1, most_seconds - 1));
  return {Ticks::of_seconds(lower), Ticks::of_seconds(lower + 1), {}};
}

automata::Transition move(std::size_t from, std::size_t to, automata::Formula guard,
                          std::optional<automata::Timing> timing) {
  return {ModeId(from), ModeId(to), std::move(guard), timing, {}, 0, {}};
}

automata::Component& add_part(Plant& plant, const std::string& name, const std::vector<std::string>& modes) {
  const automata::VariableId mode = plant.variables.add({name, modes});
  automata::Component component{name, name, mode, {}, std::vector<double>(modes.size()), {}, {}};
  component.initial[0] = 1;
  for (const std::string& m : modes) component.modes.push_back({m, false, automata::constant(true), 0, {}});
  if (chance(50)) component.modes[up_to(0, modes.size() - 1)].reward = chance(50) ? 1 : -1;
  return plant.components.emplace_back(std::move(component));
}

Moment at_rest(const Plant& plant) {
  return {Modes(plant.components.size(), ModeId(0)), std::vector<std::int64_t>(plant.components.size())};
}

void go_on(automata::PlantStep& step, Moment& moment, const automata::ControlAction& action) {
  Modes after = moment.modes;
  for (std::size_t c = 0; c < after.size(); ++c) {
    const auto& enabled = step.enabled(ComponentId(c), moment.modes, action);
    const auto& transitions = step.plant().components[c].transitions;
    std::int64_t& seconds = moment.seconds[c];
    seconds = std::min(seconds + 1, most_seconds);
    std::optional<ModeId> next;
    for (const automata::TransitionId t : enabled.timed) {
      if (Ticks::of_seconds(seconds) >= transitions[t.index()].timing->upper) next = transitions[t.index()].to;
    }
    for (const automata::TransitionId t : enabled.untimed) next = transitions[t.index()].to;
    if (next && *next != after[c]) {
      after[c] = *next;
      seconds = 0;
    }
  }
  moment.modes = std::move(after);
}

}  // namespace rmpl::property
