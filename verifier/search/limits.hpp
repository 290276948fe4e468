// What a search may cost, and what it has cost.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

namespace rmpl::verifier {

/// What ended a search before its end: what it may cost, a signal, or that a plan leads there.
enum class Limit { states, time, memory, interrupt, plan };

/// How far a search is, or how far it got.
struct Progress {
  std::size_t states = 0;   ///< symbolic states found
  std::size_t waiting = 0;  ///< of those, not yet explored
  /// In order of steps: every state within so many has been found. In order of faults: nothing.
  std::optional<std::size_t> steps;
  unsigned level = 0;   ///< in order of faults: every run with fewer faults has been looked at
  unsigned faults = 0;  ///< the most that an explored state has used
  double seconds = 0;
};

/// What a search may cost; nothing set is no limit.
struct Limits {
  std::optional<std::size_t> states;
  std::optional<std::chrono::duration<double>> time;
  std::optional<std::size_t> bytes;                       ///< resident memory of the process, at its peak
  const std::atomic<bool>* interrupted = nullptr;         ///< set from outside, as by a signal
  std::function<void(const Progress&)> report = nullptr;  ///< called now and then, about twice a second
};

/// The limits less what has been spent: those of a search that goes on where another one ended.
Limits remaining(Limits limits, const Progress& spent);

/// Thrown by `Meter` where a limit is reached; searches catch it and say so.
struct LimitReached {
  Limit limit;
};

/// Thrown by `Meter` where an allowance is spent.
struct AllowanceSpent {};

/// The greatest resident memory of this process so far, in bytes.
std::size_t peak_bytes();

/// Watches one check against its limits.
class Meter {
 public:
  explicit Meter(const Limits& limits) : limits_(limits) {}

  /// What is tried first may find so many states as long as this lives. Not to be nested.
  class [[nodiscard]] Allowance {
   public:
    Allowance(Meter& meter, std::size_t states) : meter_(meter) { meter_.allowed_ = meter_.progress_.states + states; }
    ~Allowance() { meter_.allowed_.reset(); }
    Allowance(const Allowance&) = delete;
    Allowance& operator=(const Allowance&) = delete;

   private:
    Meter& meter_;
  };

  /// Is called once where so many states more have been found, as long as this lives; may throw. Not to be nested.
  class [[nodiscard]] Milestone {
   public:
    Milestone(Meter& meter, std::size_t states, std::function<void()> reached) : meter_(meter) {
      meter_.milestone_ = {meter_.progress_.states + states, std::move(reached)};
    }
    ~Milestone() { meter_.milestone_.reset(); }
    Milestone(const Milestone&) = delete;
    Milestone& operator=(const Milestone&) = delete;

   private:
    Meter& meter_;
  };

  /// To be called often. Throws LimitReached.
  void poll();
  /// One more symbolic state. Throws LimitReached and AllowanceSpent.
  void count_state();
  /// A state with so many faults is explored.
  void used_faults(unsigned faults);
  /// Where a search is, for reports: how many states are not explored yet.
  void at(std::size_t waiting);
  /// Where a search in order of steps is.
  void at_steps(std::size_t steps, std::size_t waiting);
  /// Where a search in order of faults is.
  void at_faults(unsigned faults, std::size_t waiting);

  [[nodiscard]] Progress progress() const;

 private:
  [[nodiscard]] double seconds() const;

  const Limits& limits_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::size_t polls_ = 0;
  double last_report_ = 0;
  std::optional<std::size_t> allowed_;  ///< how many states there may be in all
  std::optional<std::pair<std::size_t, std::function<void()>>> milestone_;
  Progress progress_;
};

}  // namespace rmpl::verifier
