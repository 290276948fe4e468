// A run of a plant, a step at a time.
// SPDX-License-Identifier: MIT
#include "verifier/witness/plant_run.hpp"

#include <algorithm>

#include "verifier/witness/rules.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::ControlAction;
using automata::Enabled;
using automata::Modes;
using automata::Ticks;

std::string at(Ticks time) { return " at " + automata::format_seconds(time) + " s"; }

std::optional<std::string> PlantRun::start(const Modes& modes, const std::vector<Assignment>& from) {
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const Component& component = plant().components[c];
    const auto given =
        std::find_if(from.begin(), from.end(), [&](const Assignment& a) { return a.variable == component.mode; });
    const bool right =
        given == from.end() ? component.initial[modes[c].index()] > 0 : given->value.value == modes[c].value;
    if (!right) return component.name + " does not start so";
  }
  if (!rules_.possible(modes)) return "it starts in an impossible state";
  state_ = {modes, std::vector<Ticks>(modes.size(), Ticks{0})};
  commanded_.reset();
  return std::nullopt;
}

const std::vector<Enabled>& PlantRun::enabled(const ControlAction& action) {
  if (commanded_ != action) {
    enabled_ = rules_.enabled(state_.modes, action);
    commanded_ = action;
  }
  return enabled_;
}

template <class Test>
bool PlantRun::every_component(const ControlAction& action, Ticks before, Ticks now, const Test& test) {
  const std::vector<Enabled>& all = enabled(action);
  for (std::size_t c = 0; c < all.size(); ++c) {
    const Ticks start = state_.clock_starts[c];
    if (!test(Rules(plant().components[c], all[c], before - start, now - start, period_), c)) return false;
  }
  return true;
}

bool PlantRun::may_step(const ControlAction& action, Ticks before, Ticks now, const Modes& next) {
  const bool allowed = every_component(
      action, before, now, [&](const Rules& rules, std::size_t c) { return rules.allows(state_.modes[c], next[c]); });
  if (!allowed || !period_) return allowed;
  std::vector<std::vector<automata::Move>> moves;
  for (std::size_t c = 0; c < next.size(); ++c) {
    moves.push_back(automata::moves_of(plant().components[c], state_.modes[c], enabled_[c],
                                       now - state_.clock_starts[c], now - before));
  }
  return automata::lead(moves, next);
}

bool PlantRun::may_wait(const ControlAction& action, Ticks before, Ticks now) {
  return every_component(action, before, now,
                         [&](const Rules& rules, std::size_t c) { return rules.allows_time(state_.modes[c]); });
}

void PlantRun::age(const std::vector<Event>& events, std::size_t first, Ticks by) {
  for (std::size_t c = 0; c < state_.modes.size(); ++c) {
    const bool moves = std::any_of(events.begin() + static_cast<std::ptrdiff_t>(first), events.end(),
                                   [&](const Event& event) { return event.modes[c] != state_.modes[c]; });
    if (!moves) state_.clock_starts[c] = state_.clock_starts[c] - by;
  }
}

void PlantRun::advance(const Modes& next, Ticks now) {
  if (next != state_.modes) commanded_.reset();
  state_ = automata::advance(state_, next, now);
}

std::vector<Ticks> PlantRun::meets_bounds(Ticks longest) const {
  std::vector<Ticks> result;
  for (std::size_t c = 0; c < state_.modes.size(); ++c) {
    for (const automata::Transition& t : plant().components[c].transitions) {
      if (t.from != state_.modes[c] || !t.timing) continue;
      for (const Ticks bound : {t.timing->lower, t.timing->upper}) {
        if (!bound.is_infinite() && bound <= longest) result.push_back(state_.clock_starts[c] + bound);
      }
    }
  }
  return result;
}

}  // namespace rmpl::verifier
