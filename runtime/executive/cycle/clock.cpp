// Simulated and real time.
// SPDX-License-Identifier: MIT
#include "runtime/executive/cycle/clock.hpp"

#include <algorithm>
#include <thread>
#include <utility>

namespace rmpl::runtime {

void SimulatedClock::wait_until(automata::Ticks time) { now_ = std::max(now_, time); }

WallClock::WallClock(std::function<bool()> interrupted)
    : interrupted_(std::move(interrupted)), start_(std::chrono::steady_clock::now()) {}

automata::Ticks WallClock::now() const {
  return {std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - start_).count()};
}

void WallClock::wait_until(automata::Ticks time) {
  constexpr std::chrono::nanoseconds slice = std::chrono::milliseconds(50);
  for (automata::Ticks left = time - now(); left.count > 0 && !interrupted_(); left = time - now()) {
    std::this_thread::sleep_for(std::min(slice, std::chrono::nanoseconds(left.count)));
  }
}

}  // namespace rmpl::runtime
