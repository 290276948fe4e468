// The clocks of an instant: bounds on components, whatever has started anew since, as bounds on the zone it began in.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/function_ref.hpp"
#include "verifier/behaviour/joint_choices.hpp"
#include "verifier/search/standstill.hpp"
#include "verifier/zone/time_model.hpp"

namespace rmpl::verifier {

/// The live components at the start of the instant, whose clocks are the last ones of the zone.
class InstantClocks {
 public:
  /// `others` clocks come before those of the live components, which are ascending.
  InstantClocks(std::vector<automata::ComponentId> live, std::size_t others)
      : live_(std::move(live)), others_(others) {}

  /// Nothing where the component was not live.
  [[nodiscard]] std::optional<std::size_t> clock_of(automata::ComponentId component) const;
  /// The box, `earlier` units before it and ended so many before its end. Nothing where it is empty, or a clock that
  /// has started since is not within its bounds.
  [[nodiscard]] std::optional<ZoneBox> translated(const Box& box, Units earlier, Units before_end) const;
  /// The box of a step without what exists at one instant only. Where time stops at a bound (`at_bound`), that is the
  /// end of a cycle: an exit whose lower bound is met there has not been possible in it. Later in the same instant it
  /// is.
  [[nodiscard]] std::optional<ZoneBox> lasting(const Box& box, bool at_bound) const;
  /// The clocks of those that change their modes, and of those that restarts start anew.
  [[nodiscard]] std::vector<std::size_t> restarted(const automata::Modes& from, const automata::Modes& to,
                                                   const std::vector<automata::ComponentId>& anew) const;
  /// The step in which clocks start anew, and no mode changes, as steps that each start one that reads more than 0:
  /// from `step`, which has the bounds.
  void add_restarts(const Instant& step, const std::vector<automata::ComponentId>& anew,
                    base::FunctionRef<void(Instant&&)> add) const;

 private:
  /// The box with the ranges that `range_of` makes of its bounds.
  template <class Range>
  [[nodiscard]] std::optional<ZoneBox> translated(const Box& box, const Range& range_of) const;

  std::vector<automata::ComponentId> live_;
  std::size_t others_;
};

/// Where the components' faults are certain, as bounds on the zone of a state: in sampled time by the end of the period
/// that begins.
std::vector<ZoneBox> certain_faults(std::span<const ClockBound> faulty, const InstantClocks& clocks,
                                    const TimeModel& time);

/// Whether at some reading of the zone, whose last clocks are those of the live components, more than `left` of these
/// faults are certain.
bool more_certain(const Zone& zone, std::span<const ClockBound> faulty, std::size_t left,
                  const std::vector<automata::ComponentId>& live, std::size_t others, const TimeModel& time);

}  // namespace rmpl::verifier
