// A plant and a question as one timed automaton: what tools of that theory can read.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/property/commands.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/zone/time_model.hpp"

namespace rmpl::verifier {

/// A clock, by its position, within an interval of whole units.
struct ClockRange {
  std::size_t clock;
  Interval range;
  auto operator<=>(const ClockRange&) const = default;
};

struct Location {
  automata::Modes modes;
  std::vector<ClockRange> invariant;  ///< upper bounds only
  bool urgent = false;                ///< no time passes here
  bool target = false;                ///< what is asked for holds here
};

struct Edge {
  std::size_t from;
  std::size_t to;
  std::vector<ClockRange> guard;
  std::vector<std::size_t> resets;
  unsigned faults = 0;
};

/// The reachable mode combinations as locations, joint steps as edges. Constants are multiples of `time.unit()`. It
/// reaches a target location exactly where the plant reaches the target in dense time (semantics 7).
struct TimedAutomaton {
  TimeModel time;
  std::vector<automata::ComponentId> clocks;  ///< of which component each is
  std::vector<Location> locations;
  std::vector<Edge> edges;
  std::vector<std::size_t> initial;  ///< all clocks 0; none where the initial modes are impossible
  unsigned faults = 0;               ///< the most that may happen: the sum over the edges taken
};

/// What is asked of another tool: can the target be reached.
struct ExportQuestion {
  automata::Formula target;
  bool entailed = false;
  unsigned faults = 0;
  Commands commands = Commands::one;
  std::vector<automata::Assignment> from;  ///< modes, in place of the initial distribution
};

/// Unfolds the modes, not the time: as many locations as mode combinations that guards let follow each other. A
/// location is counted against the limits as a state. Throws LimitReached.
TimedAutomaton unfold(automata::PlantStep& step, const ExportQuestion& question, const Limits& limits);

/// `valve = open, engine = off`.
std::string describe(const automata::Plant& plant, const automata::Modes& modes);

}  // namespace rmpl::verifier
