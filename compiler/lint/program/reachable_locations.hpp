// The locations of a program that may be marked, with all conditions free that can hold and can fail.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "automata/program.hpp"

namespace rmpl::compiler {

/// What a condition may be: asked once of each guard, maintenance condition and goal of a program.
struct Freedom {
  bool may_hold = true;
  bool may_fail = true;
};
using FreedomOf = std::function<Freedom(const automata::Condition&)>;

/// An arc, of whichever automaton.
struct FlowArc {
  automata::LocationId target;
  Freedom guard;
  const automata::Condition* condition = nullptr;  ///< the guard, where it is one condition
};

/// A location, of whichever automaton, with what there is to say of its conditions.
struct FlowLocation {
  bool composite = false;
  bool start = false;  ///< it is marked with its parent
  std::optional<automata::LocationId> parent;
  bool may_be_left = false;                  ///< of a composite: its maintenance condition may fail
  bool may_go_on = true;                     ///< of a primitive location: it may take its arcs
  std::vector<std::vector<FlowArc>> draws;   ///< one of them is drawn, and its arcs count; a composite has one
  std::vector<automata::LocationId> passed;  ///< what a draw counts as started: reached, and left in the same step
};
/// By location; children stand behind their parents.
using Flow = std::vector<FlowLocation>;

/// The flow of a control program. Its arcs refer to the program.
Flow flow_of(const automata::Program& program, const FreedomOf& freedom);

/// Two least fixpoints over the locations: which may come to an end, with all that follows from them, and which may be
/// marked. What is not marked here is never marked; threads are taken for independent, so what is may not be.
class ReachableLocations {
 public:
  /// `starts`: what may be marked at the start beside the first location with what it starts.
  explicit ReachableLocations(Flow flow, const std::vector<automata::LocationId>& starts = {});

  [[nodiscard]] bool reached(automata::LocationId location) const { return reached_[location.index()]; }
  [[nodiscard]] const std::vector<bool>& reached() const { return reached_; }
  /// Whether nothing may be left of a location, some time after it was marked. Of a composite: of what it holds, and
  /// of what follows it.
  [[nodiscard]] bool may_vanish(automata::LocationId location) const { return vanishes_[location.index()]; }
  /// Whether a composite may end: what it holds vanishes, or its maintenance condition fails.
  [[nodiscard]] bool may_end(automata::LocationId composite) const;

 private:
  void add_entries(std::size_t source, std::size_t target);
  bool update_vanishing(std::size_t location);
  [[nodiscard]] bool may_leave(std::size_t location) const;
  [[nodiscard]] bool may_vanish(const std::vector<FlowArc>& arcs) const;
  void mark(std::size_t location);

  Flow flow_;
  std::vector<std::vector<std::size_t>> starts_;   ///< per composite, its start locations
  std::vector<std::vector<std::size_t>> entries_;  ///< per composite, what arcs from outside lead to within it
  std::vector<bool> vanishes_;
  std::vector<bool> reached_;
  std::vector<std::size_t> pending_;
};

}  // namespace rmpl::compiler
