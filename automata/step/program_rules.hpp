// The rules of semantics 2: one cycle of a THCA (Fig. 5-3), given what the store entails. Pure.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "automata/program.hpp"
#include "automata/time/time.hpp"

namespace rmpl::automata {

/// Marked locations, ascending. Empty: the program has ended.
using Marking = std::vector<LocationId>;

/// Times or readings of clocks, by `ClockId`; nothing where a clock is inactive.
using ClockTimes = std::vector<std::optional<Ticks>>;

/// Two locations that assert different modes of one component in the same cycle (semantics 2).
struct GoalConflict {
  LocationId first, second;
  Assignment asserted, contradicted;
};

/// A conjunct of a goal that assigns no mode.
struct GoalConstraint {
  Formula formula;
  LocationId by;  ///< the first location that asserts it
  bool operator==(const GoalConstraint&) const = default;
};

/// Goals that are asked for together.
struct Goals {
  std::vector<Assignment> goal;             ///< modes, sorted by variable, each once
  std::vector<LocationId> by;               ///< for each of the goal, the first location that asserts it
  std::vector<GoalConstraint> constraints;  ///< the other conjuncts, each once
  bool operator==(const Goals&) const = default;

  [[nodiscard]] bool empty() const { return goal.empty() && constraints.empty(); }
  /// The modes, then the constraints.
  [[nodiscard]] Formula formula() const;
};

/// Goals of several that are all asked for.
Goals together(std::span<const Goals> several);

/// The first half of a cycle, steps 1 to 4 of Fig. 5-3: what is asserted before the plant is acted on. These are the
/// goals of the program itself; each branch of an `each` that asserts something has goals of its own.
struct Asserted : Goals {
  std::vector<Goals> branches;          ///< in the order of the program, outer branches before inner ones; none empty
  std::vector<GoalConflict> conflicts;  ///< where not empty, no goal is to be acted on
};

/// What the rules ask of the store, about one time. Answers may be remembered; they do not change.
class ProgramAnswers {
 public:
  /// Whether the maintenance condition of a location holds.
  virtual bool maintained(LocationId location) = 0;
  /// Whether the guard of an arc, by its position in the location, holds.
  virtual bool guard_holds(LocationId location, std::size_t arc) = 0;
  /// Whether the goal that a location asserts is entailed.
  virtual bool achieved(LocationId location) = 0;

 protected:
  ~ProgramAnswers() = default;
};

/// What the second half of a cycle goes on from.
struct HalfCycle {
  Marking marking;             ///< what works on
  std::vector<bool> working;   ///< per location: marked, and not left with a composite that was violated
  std::vector<bool> violated;  ///< per location: its own maintenance condition failed
  ClockTimes started;          ///< clocks that start in this cycle included
};

/// Keeps a reference to the program.
class ProgramRules {
 public:
  explicit ProgramRules(const Program& program);

  [[nodiscard]] const Program& program() const { return program_; }
  /// m_F of the program.
  [[nodiscard]] Marking initial() const;
  /// The readings at `now` of clocks that started then.
  [[nodiscard]] static ClockTimes readings(const ClockTimes& started, Ticks now);
  /// Steps 2 to 4 at `now`: leaves what goes on in `half`, and what is asserted in `asserted`.
  void begin(const Marking& marking, const ClockTimes& started, Ticks now, ProgramAnswers& answers, HalfCycle& half,
             Asserted& asserted) const;
  /// Steps 7 to 10: the next marking; `started` becomes when the clocks that are then active started.
  [[nodiscard]] Marking finish(const HalfCycle& half, ProgramAnswers& answers, ClockTimes& started) const;

 private:
  class Marked;

  void mark_fully(LocationId location, Marked& marked) const;
  /// The clocks of what is marked fully with a location become inactive.
  void stop_own_clocks(LocationId entered, ClockTimes& started) const;

  const Program& program_;
  std::vector<std::vector<LocationId>> children_;
  std::vector<std::size_t> parts_;  ///< per location, as `goal_parts_of` numbers them
  std::size_t branches_;            ///< of all `each`
};

}  // namespace rmpl::automata
