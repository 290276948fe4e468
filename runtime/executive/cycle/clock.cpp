// Simulated time, paced or not.
// SPDX-License-Identifier: MIT
#include "runtime/executive/cycle/clock.hpp"

#include <algorithm>
#include <thread>
#include <utility>

namespace rmpl::runtime {

void SimulatedClock::wait_until(automata::Ticks time) { now_ = std::max(now_, time); }

PacedClock::PacedClock(std::function<bool()> interrupted)
    : interrupted_(std::move(interrupted)), start_(std::chrono::steady_clock::now()) {}

void PacedClock::wait_until(automata::Ticks time) {
  constexpr std::chrono::nanoseconds slice = std::chrono::milliseconds(50);
  const auto left = [&] { return std::chrono::nanoseconds(time.count) - (std::chrono::steady_clock::now() - start_); };
  for (auto rest = left(); rest.count() > 0 && !interrupted_(); rest = left()) {
    std::this_thread::sleep_for(std::min(slice, std::chrono::duration_cast<std::chrono::nanoseconds>(rest)));
  }
  now_ = std::max(now_, time);
}

}  // namespace rmpl::runtime
