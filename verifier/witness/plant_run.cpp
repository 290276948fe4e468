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

bool PlantRun::may_wait(const ControlAction& action, Ticks before, Ticks now, const std::vector<bool>& held) {
  const std::vector<Enabled>& all = enabled(action);
  for (std::size_t c = 0; c < all.size(); ++c) {
    const Ticks start = state_.clock_starts[c];
    const Ticks end = !held.empty() && held[c] ? before : now;
    const Rules rules(plant().components[c], all[c], before - start, end - start, period_);
    if (!rules.allows_time(state_.modes[c])) return false;
  }
  return true;
}

void PlantRun::age(const automata::SystemState& begun, const std::vector<Event>& events, std::size_t first, Ticks by) {
  for (std::size_t c = 0; c < state_.modes.size(); ++c) {
    const bool moves = std::any_of(events.begin() + static_cast<std::ptrdiff_t>(first), events.end(),
                                   [&](const Event& event) { return event.modes[c] != state_.modes[c]; });
    if (!moves && state_.clock_starts[c] == begun.clock_starts[c]) state_.clock_starts[c] = state_.clock_starts[c] - by;
  }
}

std::vector<bool> PlantRun::restarted(const ControlAction& action) {
  std::vector<bool> result(state_.modes.size(), false);
  if (!has_restarts_) return result;
  const std::vector<Enabled>& all = enabled(action);
  for (std::size_t c = 0; c < all.size(); ++c) result[c] = automata::restarts(plant().components[c], all[c]);
  return result;
}

bool PlantRun::tells_too_much(const Event& event) {
  if (event.restarted.empty()) return false;
  const std::vector<bool> anew = restarted(event.action);
  return std::any_of(event.restarted.begin(), event.restarted.end(), [&](ComponentId c) {
    return !anew[c.index()] || event.modes[c.index()] != state_.modes[c.index()];
  });
}

void PlantRun::restart(const std::vector<bool>& restarted, Ticks now) {
  state_ = automata::advance(state_, restarted, state_.modes, now);
}

void PlantRun::advance(const ControlAction& action, const Modes& next, Ticks now) {
  const std::vector<bool> anew = restarted(action);
  if (next != state_.modes) commanded_.reset();
  state_ = automata::advance(state_, anew, next, now);
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
