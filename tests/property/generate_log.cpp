// Random logs: what a random run of a plant is told and shows.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/belief.hpp"

namespace rmpl::property {

using automata::Assignment;
using automata::Component;
using automata::ModeId;
using automata::Plant;
using automata::Ticks;
using automata::ValueId;
using automata::VariableId;

namespace {

/// Follows one random run of a plant and tells what its sensors show.
class LogDraw {
 public:
  explicit LogDraw(const reference::Step& step) : step_(step), plant_(step.plant()) {
    std::vector<automata::SystemState> starts;
    for (const auto& [state, probability] : reference::initial_belief(step_)) starts.push_back(state);
    state_ = pick(starts);
  }

  LogLine next() {
    const Ticks before = now_;
    now_ += Ticks{static_cast<std::int64_t>(pick<std::size_t>({2, 1, 3, 6})) * Ticks::per_second / 2};
    LogLine line{now_, *actions_of(plant_), {}};
    advance(line.action, before);
    line.observation = chance(85) ? seen() : wild();
    return line;
  }

 private:
  void advance(const automata::ControlAction& action, Ticks before) {
    automata::Modes next;
    for (std::size_t i = 0; i < plant_.components.size(); ++i) {
      const std::vector<double> distribution = step_.distribution(i, state_, action, before, now_);
      std::vector<ModeId> possible;
      for (std::size_t mode = 0; mode < distribution.size(); ++mode)
        if (distribution[mode] > 0) possible.emplace_back(mode);
      next.push_back(pick(possible));
    }
    if (step_.possible(next)) state_ = step_.advance(state_, action, next, now_);
  }

  automata::Observation seen() {
    const auto worlds = step_.models().matching(reference::assumptions_of(plant_, state_.modes));
    const reference::World& world = *pick(worlds);
    automata::Observation observation;
    for (VariableId variable : plant_.observables)
      if (chance(80)) observation.push_back({variable, world[variable.index()]});
    std::sort(observation.begin(), observation.end());
    return observation;
  }

  automata::Observation wild() {
    automata::Observation observation;
    for (std::size_t v = 0; v < plant_.variables.size(); ++v) {
      const VariableId variable(v);
      if (plant_.component_of(variable)) continue;
      const auto& shown = plant_.observables;
      // A log may tell of attributes that the plant does not declare as observed.
      const bool declared = std::find(shown.begin(), shown.end(), variable) != shown.end();
      if (chance(declared ? 60 : 10))
        observation.push_back({variable, ValueId(up_to(0, plant_.variables[variable].values.size() - 1))});
    }
    return observation;
  }

  const reference::Step& step_;
  const Plant& plant_;
  automata::SystemState state_;
  Ticks now_;
};

}  // namespace

void showValue(const Log& log, std::ostream& out) {
  for (const LogLine& line : log.lines) {
    out << "\n{\"time\":" << automata::format_seconds(line.time) << ",\"command\":[";
    for (ValueId value : line.action) out << ' ' << value.value;
    out << " ],\"observations\":[";
    for (Assignment a : line.observation) out << ' ' << a.variable.value << '=' << a.value.value;
    out << " ]}";
  }
}

rc::Gen<Log> logs(const Plant& plant, std::size_t max_length) {
  return rc::gen::exec([plant, max_length] {
    const reference::Step step(plant);
    LogDraw draw(step);
    Log log;
    const std::size_t length = up_to(1, max_length);
    for (std::size_t i = 0; i < length; ++i) log.lines.push_back(draw.next());
    return log;
  });
}

rc::Gen<Log> resting_logs(const Plant& plant, std::size_t max_length, std::size_t most) {
  return rc::gen::exec([plant, max_length, most] {
    const Log drawn = *logs(plant, max_length);
    Log log;
    Ticks before;
    Ticks later;  // how much the lines that came again put off the others
    for (const LogLine& line : drawn.lines) {
      const Ticks step = line.time - before;
      before = line.time;
      const std::size_t times = 1 + (chance(60) ? up_to(1, most) : 0);
      for (std::size_t i = 0; i < times; ++i) {
        if (i > 0) later += step;
        log.lines.push_back({line.time + later, line.action, line.observation});
      }
    }
    return log;
  });
}

}  // namespace rmpl::property
