// Observers: what is looked for along a run, as an automaton beside the plant that reads nothing but modes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "automata/state.hpp"
#include "verifier/zone/interval.hpp"

namespace verifier {

/// Where an observer is.
enum class Phase : std::uint8_t {
  searching,  ///< nothing yet
  armed,      ///< accepted, if the stopwatch reads right
  closed      ///< nothing can be accepted from here on: such states are not explored
};

/// One extra clock is kept where time matters: the stopwatch.
class Observer {
 public:
  using Test = std::function<bool(const automata::Modes&)>;

  /// Accepts where `target` holds while the absolute time is in `window`.
  static Observer reach(Test target, std::optional<Interval> window);
  /// Accepts where, after `after` has first held, `then` has not held up to and including `deadline` - 1 units later.
  static Observer miss(Test after, Test then, Units deadline);

  [[nodiscard]] Phase start(const automata::Modes& modes) const { return next(Phase::searching, modes); }
  /// The phase after a step into the modes.
  [[nodiscard]] Phase next(Phase phase, const automata::Modes& modes) const;

  /// Whether the stopwatch runs. It starts at 0 in the first phase in which it does.
  [[nodiscard]] bool timed(Phase phase) const { return stopwatch_ && (!response_ || phase == Phase::armed); }
  /// The readings at which an armed state is accepted.
  [[nodiscard]] const std::optional<Interval>& accepted() const { return stopwatch_; }

 private:
  Observer(bool response, Test trigger, Test release, std::optional<Interval> stopwatch)
      : response_(response), trigger_(std::move(trigger)), release_(std::move(release)), stopwatch_(stopwatch) {}

  bool response_;
  Test trigger_;
  Test release_;
  std::optional<Interval> stopwatch_;
};

}  // namespace verifier
