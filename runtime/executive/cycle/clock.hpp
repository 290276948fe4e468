// The system clock that the executive asks: simulated, or in step with the wall's (thesis 7.1.1, steps 1 and 13).
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
  /// Afterwards `now()` is at least `time`. Returns at once where the run was interrupted.
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

/// Simulated time that is never ahead of the machine's monotonic clock, which counts from the construction on. A cycle
/// that takes the machine longer than it says makes the flight late, and no other: what happens is as simulated. A
/// wait looks for an interruption twenty times a second.
class PacedClock final : public Clock {
 public:
  explicit PacedClock(std::function<bool()> interrupted);
  [[nodiscard]] automata::Ticks now() const override { return now_; }
  void wait_until(automata::Ticks time) override;

 private:
  automata::Ticks now_;
  std::function<bool()> interrupted_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace rmpl::runtime
