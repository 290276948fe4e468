// The two models of time (semantics 7), both counted in whole units.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "automata/plant.hpp"
#include "automata/time/time.hpp"
#include "verifier/zone/interval.hpp"

namespace rmpl::verifier {

/// How long a step is where nothing says so: a second if software is a part of the plant and nothing in it has times.
/// Nothing: time is dense.
std::optional<automata::Ticks> usual_period(const automata::Plant& plant);

/// Throws base::InputError where software is a part of the plant: it takes a step a cycle.
void refuse_dense_time(const automata::Plant& plant);

/// How time is read, and what one unit of it is.
///
/// Dense: the limit of ever shorter cycles. The unit is the greatest that divides every finite bound of the plant and
/// of the question: as all bounds are weak, whatever is possible is possible at whole units (Henzinger, Manna, Pnueli:
/// What good are digital clocks?, 1992). Sampled: one step at each multiple of the period, which is the unit.
class TimeModel {
 public:
  /// `others` are the finite times of the question. Throws base::InputError where a bound is too many units long to add
  /// up.
  static TimeModel dense(const automata::Plant& plant, std::span<const automata::Ticks> others);
  /// `period` is above 0.
  static TimeModel sampled(automata::Ticks period);
  /// Sampled where there is a period, else dense; then in halves of the greatest such unit, where nanoseconds can be
  /// halved, as fewer steps are possible between two bounds than at either (search/standstill.hpp looks there).
  static TimeModel of(std::optional<automata::Ticks> period, const automata::Plant& plant,
                      std::span<const automata::Ticks> others);

  [[nodiscard]] bool is_dense() const { return dense_; }
  [[nodiscard]] automata::Ticks unit() const { return unit_; }

  /// The fewest units that are at least `time`; `unbounded` for an infinite one.
  [[nodiscard]] Units at_least(automata::Ticks time) const;
  /// The most units that are at most `time`; `unbounded` for an infinite one.
  [[nodiscard]] Units at_most(automata::Ticks time) const;
  /// How many units make the greatest that divides every bound, or the period.
  [[nodiscard]] Units grain() const { return grain_; }
  /// The fewest of those that are more than a finite `time`.
  [[nodiscard]] Units more_than(automata::Ticks time) const { return at_most(time) + grain_; }
  /// Throws base::InputError where the time is beyond the range of Ticks.
  [[nodiscard]] automata::Ticks ticks(Units units) const;

 private:
  TimeModel(bool dense, automata::Ticks unit) : dense_(dense), unit_(unit) {}

  bool dense_;
  automata::Ticks unit_;
  Units grain_ = 1;
};

}  // namespace rmpl::verifier
