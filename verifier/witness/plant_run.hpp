// Where a run of a plant has come to, and what the rules let it do from there: what every replay stands on.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/step/plain_step.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// ` at 3 s`: of the event at which a run fails.
std::string at(automata::Ticks time);

/// A run, a step at a time, by exact comparison of ticks, over rules that remember nothing: no search has a part in it.
/// Keeps a reference. What is enabled where it is, it asks once for as long as modes and command stay.
class PlantRun {
 public:
  /// `period`: sampled time, else dense.
  PlantRun(automata::PlainStep& rules, std::optional<automata::Ticks> period)
      : rules_(rules), period_(period), has_restarts_(automata::has_restarts(rules.plant())) {}

  [[nodiscard]] const automata::Plant& plant() const { return rules_.plant(); }
  [[nodiscard]] automata::PlainStep& rules() { return rules_; }
  [[nodiscard]] const automata::SystemState& state() const { return state_; }

  /// Sets out at time 0. Why it may not in these modes, `from` standing in place of the initial distribution of the
  /// components that it names; nothing where it may.
  std::optional<std::string> start(const automata::Modes& modes, const std::vector<automata::Assignment>& from);
  /// Whether every component may go to its mode in `next` in a step from `before` to `now`; in sampled time also
  /// whether the step has a positive probability. Whether `next` can be is for `rules().possible`.
  bool may_step(const automata::ControlAction& action, automata::Ticks before, automata::Ticks now,
                const automata::Modes& next);
  /// Dense time: whether time may have passed from `before` up to `now` with nothing changing. The clocks of components
  /// that are `held` start anew all the while.
  bool may_wait(const automata::ControlAction& action, automata::Ticks before, automata::Ticks now,
                const std::vector<bool>& held = {});
  [[nodiscard]] bool has_restarts() const { return has_restarts_; }
  /// Back to where it was, in the same modes.
  void come_back(const automata::SystemState& state) { state_ = state; }
  /// The components that do not move between the events of a part of a run, and whose clocks no restart started anew
  /// since it began, have been where they are for so much longer.
  void age(const automata::SystemState& begun, const std::vector<Event>& events, std::size_t first, automata::Ticks by);
  /// Takes the step; also cycles up to `now` in which nothing changes, one after the other.
  void advance(const automata::ControlAction& action, const automata::Modes& next, automata::Ticks now);
  /// By component, whose clocks a step under the action starts anew in its mode.
  [[nodiscard]] std::vector<bool> restarted(const automata::ControlAction& action);
  /// Whether the event tells restarts that are none.
  [[nodiscard]] bool tells_too_much(const Event& event);
  /// These clocks have been started anew.
  void restart(const std::vector<bool>& restarted, automata::Ticks now);

  /// When the clocks meet those bounds, no later than `bound <= longest`, of transitions out of the present modes.
  [[nodiscard]] std::vector<automata::Ticks> meets_bounds(automata::Ticks longest) const;

 private:
  const std::vector<automata::Enabled>& enabled(const automata::ControlAction& action);
  /// Whether `test(rules of the component, component)` holds for all, their clocks reading what they do at these times.
  template <class Test>
  bool every_component(const automata::ControlAction& action, automata::Ticks before, automata::Ticks now,
                       const Test& test);

  automata::PlainStep& rules_;
  std::optional<automata::Ticks> period_;
  bool has_restarts_;
  automata::SystemState state_;
  std::optional<automata::ControlAction> commanded_;  ///< what `enabled_` is about, in the present modes
  std::vector<automata::Enabled> enabled_;
};

/// Where the run of a plant alone has come to with an event. `Step`: PlainStep, or PlantStep.
template <class Step>
automata::SystemState state_at(Step& step, const std::vector<Event>& events, std::size_t event,
                               std::optional<automata::Ticks> period) {
  const automata::ControlAction idle = automata::idle_action(step.plant());
  const automata::Modes& start = events.front().modes;
  automata::SystemState state{start, std::vector<automata::Ticks>(start.size(), automata::Ticks{0})};
  for (std::size_t e = 1; e <= event; ++e) {
    const automata::Ticks begin = events[e].time - period.value_or(automata::Ticks{0});
    if (begin > events[e - 1].time) state = step.advance(state, idle, state.modes, begin);
    state = step.advance(state, events[e].action, events[e].modes, events[e].time);
  }
  return state;
}

}  // namespace rmpl::verifier
