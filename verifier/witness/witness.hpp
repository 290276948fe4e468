// Witnesses: timed runs, of a plant alone or under a program, that show what a verdict rests on.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/program_step.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "runtime/reasoning/reconfigure/several_goals.hpp"
#include "verifier/witness/conflict.hpp"

namespace rmpl::verifier {

/// What a program does in the cycle that leads to an event.
struct Cycle {
  automata::Ticks begin;                                 ///< in dense time the cycle takes no time
  automata::Marking marking;                             ///< at its start
  std::vector<std::optional<automata::Ticks>> readings;  ///< of the program clocks, as this cycle sees them; nothing
                                                         ///< where a clock is not active or not read any more
  automata::Goals goals;                                 ///< that are acted on
  std::vector<runtime::LeftOut> left_out;                ///< that have no plan together with these
  std::vector<automata::GoalConflict> conflicts;
  runtime::Reconfiguration::Outcome outcome = runtime::Reconfiguration::Outcome::nothing_to_do;
  runtime::Reason why;     ///< of a command, a wait or a missing plan
  std::string reason;      ///< of a missing plan, in words
  automata::Marking next;  ///< at its end
};

/// The state that a step leads to, at the time of the step; the first event is the start, at time 0.
struct Event {
  automata::Ticks time;
  automata::Modes modes;
  automata::ControlAction action;                     ///< in force for the step
  std::optional<Cycle> cycle = std::nullopt;          ///< under a program; none at the start
  std::vector<automata::ComponentId> restarted = {};  ///< that stay in a mode with a timed exit, and restart its clock
};

/// What the last step of a run takes away, though a goal achieved it and none asks for that.
struct Undone {
  automata::ComponentId component;
  automata::ModeId mode;
  std::size_t asked;  ///< the event whose cycle asserted the goal last
  bool operator==(const Undone&) const = default;
};

/// What keeps a component where it is.
struct Hindrance {
  enum class Kind {
    missing,    ///< no nominal transition leads out of its mode
    disabled,   ///< `transition` is not enabled, nor is any other
    excluded,   ///< `transition` is enabled, and leads to impossible states only
    overtaken,  ///< `transition` is enabled, and `by`, which leads to the same mode, takes the whole of each step
  };
  Kind kind;
  automata::ComponentId component;
  automata::ModeId mode;
  std::optional<automata::TransitionId> transition;
  std::optional<automata::TransitionId> by = std::nullopt;
};

/// Another goal of a cycle without a plan, which has none by itself either; or one that is left out.
struct Refusal {
  automata::Formula goal;
  runtime::Reason why;
  std::string reason;  ///< in words
};

/// From the start to what was looked for.
///
/// Of a plant alone: between two events all controls are idle and nothing changes. Where the modes are those of the
/// event before, nothing changed: a command kept it so, or the last event is the time at which the target counts.
///
/// Under a program: between two events cycles run that change nothing; they assert and command what that of the later
/// event does. The last event is the cycle that runs at the end: its command is known, what it leads to is not, and its
/// time is its begin.
struct Witness {
  std::vector<Event> events;
  /// From this event on it goes round for ever: under a program up to the last event but one, else up to the last.
  std::optional<std::size_t> repeats_from;
  std::optional<Stop> stop;                ///< it is cut off at its last event, or that round takes no time
  std::vector<Refusal> refused = {};       ///< of a missing plan at the end
  std::vector<Hindrance> hindrances = {};  ///< of a wait that lasts for ever
  std::optional<std::size_t> owed_since = std::nullopt;  ///< of a response that is missed: the event that asked for it
  std::optional<Undone> undone = std::nullopt;           ///< of the event before the last, where that was asked
  bool waits_for_ever = false;  ///< under a program: the cycles of its last event go on for ever, and change nothing
};

/// Whether some goal of the cycle has no plan.
bool lacks_a_plan(const Cycle& cycle);

/// How many components went into a fault mode along the run.
std::size_t faults_in(const automata::Plant& plant, const Witness& witness);

}  // namespace rmpl::verifier
