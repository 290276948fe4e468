// A flight as data: what every view of it, be it a page or a file of another tool's, is made from.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "automata/monitor.hpp"
#include "automata/plant.hpp"
#include "automata/program.hpp"
#include "automata/state.hpp"
#include "automata/step/program_step.hpp"
#include "runtime/report/track.hpp"

namespace rmpl::runtime {

/// A goal and the location that asserts it, which is not known where a run is of a plant alone.
struct AssertedGoal {
  automata::Assignment goal;
  std::optional<automata::LocationId> by;
  bool operator==(const AssertedGoal&) const = default;
};

/// What a goal asks besides modes, in words.
struct AssertedConstraint {
  std::string text;
  std::optional<automata::LocationId> by;
  bool operator==(const AssertedConstraint&) const = default;
};

/// Why the plant is commanded, waited for or without a plan; empty words where there is nothing to do.
struct Explanation {
  std::string outcome;  ///< `command`, `wait`, `no-plan`
  std::string why;
  bool operator==(const Explanation&) const = default;
};

/// What happened beside the regular flow, and for how long.
struct Happening {
  std::string kind;  ///< `fault`, and as in traces: `forced`, `no-plan`, `goal-conflict`, `inconsistent`, …
  automata::Ticks from;
  std::optional<automata::Ticks> to;  ///< exclusive; nothing where it is of a moment
  std::optional<automata::ComponentId> component;
  std::string text;
  bool nominal = false;  ///< forced into a mode that is no fault
};

/// What was asked of the flight, and what came of it.
struct Asked {
  std::string text;
  std::string verdict;  ///< `met`, `failed`, `undecided`
  std::optional<automata::Ticks> time;
  std::string reason;
  std::string evidence;
};

/// What a channel of telemetry says: a finite number, or what else was written.
struct Signal {
  std::optional<double> number;
  std::string text;  ///< empty for a finite number
  bool operator==(const Signal&) const = default;
};

/// A channel that had samples, and the limits by which it is read.
struct FlownChannel {
  std::string name;
  Track<Signal> signal;                            ///< each sample up to the next one
  std::vector<automata::VariableId> attributes{};  ///< that monitors of it are about
  /// Of monitors of this channel alone: numbers that mean a value of an attribute.
  std::vector<std::pair<automata::VariableId, automata::Band>> limits{};
};

/// The share of the belief that each mode has that has any, in percent, in order of modes; empty where all but less
/// than a half percent is in the estimated mode.
using Shares = std::vector<std::pair<automata::ModeId, unsigned>>;

struct Flight {
  std::string name;
  const automata::Plant* plant = nullptr;      ///< never null; outlives the flight, as the program does
  const automata::Program* program = nullptr;  ///< null where a plant is looked at alone
  std::string verdict;                         ///< `met`, `failed`, `undecided`; `holds`, `violated`
  std::string summary;                         ///< one line: how it ended
  automata::Ticks cycle;                       ///< 0 where time is dense
  automata::Ticks end;
  std::optional<std::uint64_t> seed;

  // Per component; empty where nobody knows or nobody estimates.
  std::vector<Track<automata::ModeId>> truth;
  std::vector<Track<automata::ModeId>> estimate;
  std::vector<Track<Shares>> belief;
  std::vector<Track<automata::ValueId>> commands;                 ///< per control
  std::vector<Track<std::optional<automata::ValueId>>> readings;  ///< per observable; nothing: silent
  std::vector<FlownChannel> channels;                             ///< by name
  Track<automata::Marking> marking;
  Track<std::vector<AssertedGoal>> goals;
  Track<std::vector<AssertedConstraint>> constraints;
  Track<std::string> set_aside;  ///< readings that did not count, in words; empty where all did
  Track<Explanation> explanations;
  std::vector<Happening> happenings;  ///< in order of `from`
  std::vector<Asked> asked;
};

}  // namespace rmpl::runtime
