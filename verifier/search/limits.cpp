// What a search may cost, and what it has cost.
// SPDX-License-Identifier: MIT
#include "verifier/search/limits.hpp"

#include <algorithm>

#include "base/peak_memory.hpp"

namespace rmpl::verifier {
namespace {

/// Clock and memory are looked at once in so many polls: both cost a system call.
constexpr std::size_t polls_between_looks = 64;
constexpr double seconds_between_reports = 0.5;

}  // namespace

std::size_t peak_bytes() { return base::peak_memory(); }

Limits remaining(Limits limits, const Progress& spent) {
  if (limits.time) {
    const auto left = *limits.time - std::chrono::duration<double>(spent.seconds);
    limits.time = std::max(left, std::chrono::duration<double>::zero());
  }
  if (limits.states) *limits.states -= std::min(*limits.states, spent.states);
  return limits;
}

double Meter::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Meter::poll() {
  if (limits_.interrupted != nullptr && limits_.interrupted->load(std::memory_order_relaxed)) {
    throw LimitReached{Limit::interrupt};
  }
  if (polls_++ % polls_between_looks != 0) return;
  const double now = seconds();
  if (limits_.time && now >= limits_.time->count()) throw LimitReached{Limit::time};
  if (limits_.bytes && peak_bytes() >= *limits_.bytes) throw LimitReached{Limit::memory};
  if (limits_.report && now - last_report_ >= seconds_between_reports) {
    last_report_ = now;
    limits_.report(progress());
  }
}

void Meter::count_state() {
  if (limits_.states && progress_.states >= *limits_.states) throw LimitReached{Limit::states};
  if (allowed_ && progress_.states >= *allowed_) throw AllowanceSpent{};
  ++progress_.states;
  if (milestone_ && progress_.states > milestone_->first) std::exchange(milestone_, std::nullopt)->second();
}

void Meter::used_faults(unsigned faults) { progress_.faults = std::max(progress_.faults, faults); }

void Meter::at(std::size_t waiting) {
  progress_.steps.reset();
  progress_.level = 0;
  progress_.waiting = waiting;
}

void Meter::at_steps(std::size_t steps, std::size_t waiting) {
  at(waiting);
  progress_.steps = steps;
}

void Meter::at_faults(unsigned faults, std::size_t waiting) {
  at(waiting);
  progress_.level = faults;
}

Progress Meter::progress() const {
  Progress result = progress_;
  result.seconds = seconds();
  return result;
}

}  // namespace rmpl::verifier
