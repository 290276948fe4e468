// Observers: what is looked for along a run, as an automaton beside the plant that reads nothing but modes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "automata/state.hpp"
#include "verifier/zone/interval.hpp"

namespace rmpl::verifier {

/// Where an observer is.
enum class Phase : std::uint8_t {
  searching,   ///< nothing yet, or answered
  armed,       ///< accepted, if the stopwatch reads right
  stuck,       ///< nothing can follow
  stuck_late,  ///< as before, and what is owed could come in time only now
  still,       ///< only what takes no time can
  still_armed  ///< as before, and what is owed never comes
};

/// Whether the run is cut off there.
inline bool is_end(Phase phase) { return phase >= Phase::stuck; }

/// One extra clock is kept where time matters: the stopwatch.
class Observer {
 public:
  using Test = std::function<bool(const automata::Modes&)>;

  /// Accepts where `target` holds while the absolute time is in `window`.
  static Observer reach(Test target, std::optional<Interval> window);
  /// Accepts where, after some time at which `after` held, `then` has not held when `deadline` units have passed, the
  /// fewest that are too late; where nothing can follow, as soon as what did would be too late. What answers the first
  /// of several such times that are open answers all. Without a deadline `then` may come some day: a wait that lasts
  /// for ever, and a run that is cut off, are accepted, and a run that goes round is for `find_lasso`.
  static Observer miss(Test after, Test then, std::optional<Units> deadline);

  /// Accepts where a run is cut off.
  static Observer end();
  [[nodiscard]] bool seeks_end() const { return seeks_end_; }
  /// Readings of the stopwatch at which a response that is owed cannot come in time any more but now; `grain` is that
  /// of the time model.
  [[nodiscard]] Interval last_chance(Units grain) const { return {stopwatch_->lower - grain, unbounded}; }
  /// Whether what cannot go on matters where it hides behind what can do more.
  [[nodiscard]] bool tells_ends_apart() const { return seeks_end_ || response_; }
  /// Whether what is waited for may come some day.
  [[nodiscard]] bool some_day() const { return response_ && !stopwatch_; }
  /// Whether a response is waited for.
  [[nodiscard]] bool owes(Phase phase) const { return response_ && phase == Phase::armed; }

  [[nodiscard]] Phase start(const automata::Modes& modes) const { return next(Phase::searching, modes); }
  /// The phase after a step into the modes.
  [[nodiscard]] Phase next(Phase phase, const automata::Modes& modes) const;

  /// Whether a step from one phase to another is the response that was waited for.
  [[nodiscard]] bool answers(Phase from, Phase to) const {
    return response_ && from == Phase::armed && to == Phase::searching;
  }

  /// Whether the stopwatch runs. It starts at 0 in the first phase in which it does.
  [[nodiscard]] bool timed(Phase phase) const {
    return stopwatch_ && (!response_ || phase == Phase::armed || phase == Phase::stuck_late);
  }
  /// The readings at which an armed state is accepted.
  [[nodiscard]] const std::optional<Interval>& accepted() const { return stopwatch_; }

 private:
  Observer(bool response, Test trigger, Test release, std::optional<Interval> stopwatch)
      : response_(response), trigger_(std::move(trigger)), release_(std::move(release)), stopwatch_(stopwatch) {}

  bool seeks_end_ = false;
  bool response_;
  Test trigger_;
  Test release_;
  std::optional<Interval> stopwatch_;
};

}  // namespace rmpl::verifier
