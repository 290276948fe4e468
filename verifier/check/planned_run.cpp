// The run that reconfiguration would bring about, with times.
// SPDX-License-Identifier: MIT
#include "verifier/check/planned_run.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::verifier {

using automata::ControlAction;
using automata::Modes;
using automata::Ticks;
using automata::Transition;
using automata::TransitionId;
using runtime::Reconfiguration;

namespace {

/// Steps after which a plan, or what happens of itself meanwhile, is followed no further.
constexpr std::size_t most_steps = 1024;

class PlannedRun {
 public:
  PlannedRun(automata::PlantStep& step, const Modes& start, const automata::Formula& target,
             std::optional<Ticks> period)
      : step_(step),
        target_(target),
        period_(period),
        idle_(automata::idle_action(step.plant())),
        reconfigurer_(runtime::make_reconfigurer(step, nullptr, period.value_or(Ticks{0}))),
        state_{start, std::vector<Ticks>(start.size(), Ticks{0})} {
    witness_.events.push_back({now_, start, idle_});
  }

  std::optional<Witness> run(const Window& window) {
    for (std::size_t steps = 0; !arrived(); ++steps) {
      if (steps == most_steps) return std::nullopt;
      const Reconfiguration answer = reconfigurer_->go_on(state_.modes, target_, position_);
      if (!answer.expected || *answer.expected == state_.modes) return std::nullopt;
      follow(answer.action, *answer.expected);
      position_ = runtime::position_after(answer, state_.modes);
    }
    if (window.not_before && *window.not_before > now_) {
      now_ = period_ ? on_period(*window.not_before) : *window.not_before;
      witness_.events.push_back({now_, state_.modes, idle_});
    }
    return std::move(witness_);
  }

 private:
  [[nodiscard]] bool arrived() {
    return step_.theory().entails(assignments_of(step_.plant(), state_.modes), step_.theory().encode(target_));
  }

  /// One step towards what is expected under the action: that one, as early as its times permit; or what has to happen
  /// before it, with all controls idle.
  void follow(const ControlAction& action, const Modes& expected) {
    const Ticks due = earliest(step_.enabled(state_.modes, action), expected);
    if (period_) {
      const Ticks end = std::max(now_ + *period_, on_period(due));
      return enter(end, action, with_overdue(expected, action, end));
    }
    if (due > now_) {
      const automata::AllEnabled& waiting = step_.enabled(state_.modes, idle_);
      Modes at_once = state_.modes;
      for (std::size_t c = 0; c < at_once.size(); ++c) {
        if (!waiting[c].untimed.empty()) at_once[c] = expected[c];
      }
      if (at_once != state_.modes) return enter(now_, idle_, at_once);
      Ticks latest = due;
      Modes forced = expected;
      for (std::size_t c = 0; c < forced.size(); ++c) {
        for (const TransitionId id : waiting[c].timed) {
          const Transition& t = transition(c, id);
          if (t.to == t.from || t.timing->upper.is_infinite()) continue;
          if (state_.clock_starts[c] + t.timing->upper >= latest) continue;
          latest = state_.clock_starts[c] + t.timing->upper;
          forced = state_.modes;
          forced[c] = t.to;
        }
      }
      if (latest < due) return enter(latest, idle_, forced);
    }
    enter(due, action, expected);
  }

  /// When what is expected may happen: each timed transition has to be within its bounds.
  [[nodiscard]] Ticks earliest(const automata::AllEnabled& enabled, const Modes& expected) const {
    Ticks due = now_;
    for (std::size_t c = 0; c < expected.size(); ++c) {
      if (expected[c] == state_.modes[c] || !enabled[c].untimed.empty()) continue;
      const auto& timed = enabled[c].timed;
      const auto taken = std::find_if(timed.begin(), timed.end(),
                                      [&](TransitionId id) { return transition(c, id).to == expected[c]; });
      if (taken == timed.end()) continue;
      const automata::Timing& timing = *transition(c, *taken).timing;
      // In sampled time a period that begins at the lower bound is the first that can be it.
      const Ticks margin{period_ && timing.lower < timing.upper ? 1 : 0};
      due = std::max(due, state_.clock_starts[c] + timing.lower + margin);
    }
    return due;
  }

  /// In sampled time: other components whose bounds end by then have moved, too.
  [[nodiscard]] Modes with_overdue(Modes expected, const ControlAction& action, Ticks end) {
    const automata::AllEnabled& enabled = step_.enabled(state_.modes, action);
    for (std::size_t c = 0; c < expected.size(); ++c) {
      if (expected[c] != state_.modes[c] || !enabled[c].untimed.empty()) continue;
      for (const TransitionId id : enabled[c].timed) {
        if (end - state_.clock_starts[c] >= transition(c, id).timing->upper) expected[c] = transition(c, id).to;
      }
    }
    return expected;
  }

  void enter(Ticks time, const ControlAction& action, const Modes& modes) {
    const Ticks begin = time - period_.value_or(Ticks{0});
    if (begin > now_) state_ = step_.advance(state_, idle_, state_.modes, begin);
    now_ = time;
    state_ = step_.advance(state_, action, modes, now_);
    witness_.events.push_back({now_, modes, action});
  }

  /// The first multiple of the period that is not before.
  [[nodiscard]] Ticks on_period(Ticks time) const {
    return Ticks{(time.count + period_->count - 1) / period_->count * period_->count};
  }
  [[nodiscard]] const Transition& transition(std::size_t component, TransitionId id) const {
    return step_.plant().components[component].transitions[id.index()];
  }

  automata::PlantStep& step_;
  const automata::Formula& target_;
  std::optional<Ticks> period_;
  ControlAction idle_;
  std::unique_ptr<runtime::Reconfigurer> reconfigurer_;
  Ticks now_{0};
  automata::SystemState state_;
  runtime::StrategyPosition position_;
  Witness witness_;
};

}  // namespace

std::optional<Witness> planned_run(const automata::Plant& plant, const Modes& start, const automata::Formula& target,
                                   const Window& window, std::optional<Ticks> period) {
  automata::PlantStep step(plant);
  return PlannedRun(step, start, target, period).run(window);
}

}  // namespace rmpl::verifier
