// Timed hierarchical constraint automata: the control program (thesis 5.2.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/logic/ids.hpp"
#include "automata/logic/variables.hpp"
#include "automata/origin.hpp"
#include "automata/plant.hpp"

namespace rmpl::automata {

/// A label or a maintenance constraint: |= c where `entailed`, else the overbar, not |= c.
struct Condition {
  bool entailed = true;
  Formula constraint = constant(true);
  bool operator==(const Condition&) const = default;
  [[nodiscard]] bool is_trivial() const { return entailed && constraint.is_true(); }
};

/// One transition of a location, to one target; several can be taken at once.
struct Arc {
  Condition guard;
  LocationId target;
  bool operator==(const Arc&) const = default;
};

/// A location: primitive (it may assert a goal and start clocks) or composite (it holds other locations).
struct Location {
  bool composite = false;
  std::optional<LocationId> parent;  ///< none for location 1, the program itself
  bool start = false;                ///< one of its parent's start locations
  bool apart = false;                ///< a composite: a branch of an `each`, whose goals are asked for by themselves
  /// The conjuncts of its goal that assign a mode, and the others, which are over modes and attributes. None: true.
  std::vector<Assignment> goal;
  std::vector<Formula> goal_constraints;
  std::optional<ClockId> clock_start;
  std::vector<ClockId> own_clocks;  ///< of a composite: inactive whenever it is entered; no other has them
  Condition maintenance;            ///< applies to all that is inside
  std::vector<Arc> arcs;
  std::string label;  ///< what it is, for people: `engine = standby`, `when t1 >= 16200 s`, `EntrySequence()`
  Origin origin;
  bool operator==(const Location&) const = default;

  [[nodiscard]] bool has_goal() const { return !goal.empty() || !goal_constraints.empty(); }
};

/// The whole goal of a location.
Formula goal_of(const Location& location);

/// A THCA. Location k (from 0) is printed as k + 1; a child comes after its parent (pre-order of the source).
/// `variables` holds what the program mentions; `bind` replaces it by a plant's table.
struct Program {
  std::string name;
  Variables variables;
  std::vector<std::string> clocks;
  std::vector<Location> locations;
  bool operator==(const Program&) const = default;
};

/// Per location the part of the program whose goals it asserts: 0 is the program itself; the branches of each `each`
/// follow in the order of the program.
std::vector<std::size_t> goal_parts_of(const Program& program);

/// What the conditions of a program ask of the executive's knowledge, each atom once, in the order of the locations.
std::vector<Formula> knowledge_asked_by(const Program& program);

/// What a program asks for and a plant lacks.
struct Mismatch {
  Origin origin;  ///< of the location that asks
  std::string message;
};

/// A program bound to a plant; it means something only where nothing is lacking.
struct Binding {
  Program program;
  std::vector<Mismatch> lacking;  ///< by place, then message; each once
};

/// The program with its variables and values replaced by the plant's. An atom `x = y` whose right side is no value of
/// x but a variable of the same domain becomes an equality.
Binding bind(const Program& program, const Plant& plant);

}  // namespace rmpl::automata
