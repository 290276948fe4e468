// Where a run of a program can get to behind a location.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "automata/program.hpp"
#include "compiler/lint/program/reachable_locations.hpp"

namespace rmpl::compiler {

/// Whether a location stays marked for ever, and starts something again and again: `always` and `whenever`.
bool repeats(const automata::Location& location, automata::LocationId id);

/// Where a run can get to behind a location, with all conditions free; without entering what has `clock` as its own, if
/// there is one. For one question each. O(locations squared) where they nest, mostly O(locations and arcs).
class Onward {
 public:
  Onward(const automata::Program& program, const ReachableLocations& reach,
         std::optional<automata::ClockId> clock = std::nullopt)
      : program_(program), reach_(reach), clock_(clock), seen_(program.locations.size(), false) {}

  /// The locations that can be marked after this one, this one only where a run leads back to it.
  const std::vector<bool>& behind(automata::LocationId location);
  /// The same after what a location that repeats for ever starts each time. What the location is in ends once, and it
  /// with that.
  const std::vector<bool>& started_by(automata::LocationId repeating);

 private:
  const std::vector<bool>& followed();
  void leave(std::size_t location);
  void enter(std::size_t location);

  const automata::Program& program_;
  const ReachableLocations& reach_;
  const std::optional<automata::ClockId> clock_;
  std::vector<bool> seen_;
  std::set<std::size_t> left_;
  std::vector<std::size_t> pending_;
};

}  // namespace rmpl::compiler
