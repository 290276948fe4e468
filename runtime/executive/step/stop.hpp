// Where a run stands while it is stepped through: as data, and as text.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "automata/origin.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "base/painter.hpp"
#include "runtime/executive/step/prospects.hpp"

namespace rmpl::runtime {

/// The end of a cycle, and what has been decided for the next one.
struct Stop {
  struct Fact {
    std::string name, value;
    bool fault = false;
    std::optional<automata::Ticks> since;  ///< of a mode: when its clock began, where that is known
  };
  struct Line {
    std::string text;
    automata::Origin origin;
  };
  struct Believed {
    double probability = 0;
    std::string text;  ///< the modes of the most likely state; of another one those in which it differs from that
  };
  std::uint64_t cycle = 0;  ///< that have ended; of a witness: events that have come
  bool of_witness = false;
  automata::Ticks time;
  bool ended = false;               ///< the program has ended
  bool over = false;                ///< no cycle begins: the run is over
  std::vector<Fact> truth;          ///< empty where nobody knows it
  std::vector<Fact> estimate;       ///< the most likely modes; empty where nobody estimates
  std::vector<Believed> belief;     ///< the most likely states first, at most five; empty where they are not known
  bool believes_truth = false;      ///< the estimate and the truth are the same
  std::vector<Line> marking;        ///< marked locations that hold no others
  std::vector<Line> goals;          ///< asserted in the cycle that begins
  std::string command;              ///< of the same cycle: controls off idle; empty where there are none
  std::string why;                  ///< it is sent, or nothing is
  std::vector<Fact> readings;       ///< at the end of the cycle
  std::vector<std::string> told;    ///< what of it the executive reports: conflicts, goals without a plan, surprises
  std::vector<std::string> faults;  ///< that are believed, each with its evidence where that is known
};

/// Modes as facts; `since` by component, or empty.
std::vector<Stop::Fact> facts_of(const automata::Plant& plant, const automata::Modes& modes,
                                 const std::vector<automata::Ticks>& since);
/// Readings as facts.
std::vector<Stop::Fact> facts_of(const automata::Plant& plant, const automata::Observation& readings);

/// The stop as a block of lines, at most 100 columns where names permit; ends with a line feed.
std::string to_text(const Stop& stop, base::Painter painter);
/// Reasons: of the command, of goals without a plan and surprises, of the faults that are believed. Ends with a line
/// feed.
std::string why_text(const Stop& stop, base::Painter painter);

/// What may come, a line each; what can be chosen has its number, from 1. `until`: the end of the cycle that begins.
/// Ends with a line feed, or is empty.
std::string to_text(const std::vector<Prospect>& prospects, const automata::Plant& plant, automata::Ticks now,
                    automata::Ticks until, base::Painter painter);

/// Whether a prospect can be chosen for the cycle that begins.
bool can_be_chosen(const Prospect& prospect);
/// It in one line, without its number.
std::string to_text(const Prospect& prospect, const automata::Plant& plant, automata::Ticks now);

}  // namespace rmpl::runtime
