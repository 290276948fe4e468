// How old a mode is, as far as that is known and matters (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <limits>

#include "automata/time/time.hpp"

namespace rmpl::runtime {

/// Since the mode was entered, in whole cycles; in dense time in ticks.
struct Age {
  std::int64_t least = 0;
  std::int64_t most = 0;
  std::int64_t charged = 0;  ///< what the worst run has been charged since then
  auto operator<=>(const Age&) const = default;
};

/// Numbers of cycles, from `first` to `last`; none where `last` is less.
struct Cycles {
  static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max() / 4;
  std::int64_t first = 1;
  std::int64_t last = never;
  [[nodiscard]] bool empty() const { return last < first; }
  [[nodiscard]] Cycles meet(Cycles other) const { return {std::max(first, other.first), std::min(last, other.last)}; }
};

/// When an exit may be taken, in cycles since its mode was entered (semantics 3): not before `first`, which is at least
/// 1, and no later than `last`, but for one that becomes enabled after that, which is taken in the next cycle.
inline Cycles window_of(automata::Ticks lower, automata::Ticks upper, automata::Ticks cycle) {
  Cycles window;
  if (!upper.is_infinite())
    window.last = std::max<std::int64_t>(1, upper.count / cycle.count + (upper.count % cycle.count != 0 ? 1 : 0));
  window.first = std::max<std::int64_t>(1, std::min(lower.count / cycle.count + 1, window.last));
  return window;
}

/// How ages grow and what they permit: in cycles of an executive, or in *dense* time, the limit of ever shorter cycles,
/// in which actions take no time and what is due at an instant may come before an action or after it.
class AgeRules {
 public:
  /// `cycle`: 0 is dense time.
  explicit AgeRules(automata::Ticks cycle) : dense_(cycle.count == 0), unit_(std::max(cycle, automata::Ticks{1})) {}

  /// Of ages and of waits.
  [[nodiscard]] automata::Ticks unit() const { return unit_; }
  [[nodiscard]] Cycles window(automata::Ticks lower, automata::Ticks upper) const {
    if (!dense_) return window_of(lower, upper, unit_);
    return {lower.count, upper.is_infinite() ? Cycles::never : upper.count};
  }
  /// The age from which on nothing changes in a mode, by one of its exits. In dense time what is overdue is more than
  /// due.
  [[nodiscard]] std::int64_t cap(Cycles window) const {
    if (window.last == Cycles::never) return window.first;
    return std::max(window.first, window.last + (dense_ ? 1 : 0));
  }
  /// How long something takes: a wait as long as it likes, an action a cycle.
  [[nodiscard]] Cycles length(bool waits) const {
    const std::int64_t least = dense_ ? 0 : 1;
    return {least, waits ? Cycles::never : least};
  }
  /// The greatest age of a component that is still in its mode, if its first exit is due at `due`.
  [[nodiscard]] std::int64_t oldest(std::int64_t due) const { return due == Cycles::never || dense_ ? due : due - 1; }
  /// After how many cycles a component of this age may still be there.
  [[nodiscard]] Cycles staying(Age age, std::int64_t due) const {
    return {dense_ ? 0 : 1, due == Cycles::never ? due : oldest(due) - age.least};
  }
  /// After how many cycles, and not before, it may take an exit.
  [[nodiscard]] Cycles leaving(Age age, Cycles exit, std::int64_t due) const {
    return dense_ ? leaving_dense(age, exit, due) : leaving_in_cycles(age, exit, due);
  }

 private:
  static Cycles leaving_dense(Age age, Cycles exit, std::int64_t due) {
    Cycles result{std::max<std::int64_t>(0, exit.first - age.most), due == Cycles::never ? due : due - age.least};
    if (exit.first > due) result = {0, -1};
    if (age.most > due && age.most >= exit.first) result = {0, result.empty() ? 0 : result.last};
    return result;
  }
  /// In the cycle in which the first exit is due only those that are due are taken.
  static Cycles leaving_in_cycles(Age age, Cycles exit, std::int64_t due) {
    const std::int64_t last = exit.last <= due ? due : due - 1;
    Cycles result{std::max<std::int64_t>(2, exit.first - age.most), last == Cycles::never ? last : last - age.least};
    if (exit.first > last) result.last = 0;
    const bool in_time = std::max(age.least + 1, exit.first) <= std::min(age.most + 1, due - 1);
    const bool overdue = age.most + 1 >= std::max(due, exit.last);
    if (in_time || overdue) result = {1, std::max<std::int64_t>(1, result.empty() ? 1 : result.last)};
    return result;
  }

  bool dense_;
  automata::Ticks unit_;
};

}  // namespace rmpl::runtime
