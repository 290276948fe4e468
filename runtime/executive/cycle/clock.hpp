// The system clock that the executive asks: simulated, or the wall's (thesis 7.1.1, steps 1 and 13).
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>

#include "automata/time/time.hpp"

namespace rmpl::runtime {

/// Time since the start of the run.
class Clock {
 public:
  virtual ~Clock() = default;
  [[nodiscard]] virtual automata::Ticks now() const = 0;
  /// Returns once `now()` is at least `time`, or earlier where the run was interrupted.
  virtual void wait_until(automata::Ticks time) = 0;
};

/// Waiting costs nothing: time is where it was waited to, exactly.
class SimulatedClock final : public Clock {
 public:
  [[nodiscard]] automata::Ticks now() const override { return now_; }
  void wait_until(automata::Ticks time) override;

 private:
  automata::Ticks now_;
};

/// The monotonic clock of the machine, from the construction on. A wait looks for an interruption twenty times a
/// second.
class WallClock final : public Clock {
 public:
  explicit WallClock(std::function<bool()> interrupted);
  [[nodiscard]] automata::Ticks now() const override;
  void wait_until(automata::Ticks time) override;

 private:
  std::function<bool()> interrupted_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace rmpl::runtime
