// Random small plants, formulas and logs for the property tests; well formed by construction.
// SPDX-License-Identifier: MIT
#pragma once

#include <rapidcheck.h>

#include <ostream>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "automata/program.hpp"
#include "automata/state.hpp"
#include "tests/reference/rmpl.hpp"

/// What RapidCheck prints of the automata's values when a property fails; found by argument-dependent lookup.
namespace rmpl::automata {
template <class Tag>
void showValue(Id<Tag> id, std::ostream& out) {
  out << id.value;
}
inline void showValue(const Assignment& assignment, std::ostream& out) {
  out << assignment.variable.value << '=' << assignment.value.value;
}
}  // namespace rmpl::automata

// A generator owns copies of what it was given: RapidCheck runs it again to shrink, when the caller's are gone.
namespace rmpl::property {

/// What the plants of one property may contain.
struct Shape {
  std::size_t max_components = 3;
  std::size_t max_modes = 3;
  std::size_t max_attributes = 5;  ///< of the whole plant, controls among them
  bool faults = true;
  bool timed = true;
  bool densities = true;      ///< else all timed transitions are uniform between finite bounds
  bool distributions = true;  ///< several initial modes, weighted and branching nominal transitions
  bool open =
      false;  ///< nearly all that there is, is observed, and constraints leave room: readings are often unimplied
  bool rewards = false;
  bool commanded = false;     ///< every untimed nominal transition needs its component's command
  bool tangled = false;       ///< guards look at other components, and modes exclude each other: dead ends, late guards
  std::size_t restarts = 25;  ///< percent of the modes with a timed exit whose clock may start anew
};

/// A plant, printed as its JSON, which the programs read.
struct Model {
  automata::Plant plant;
};
void showValue(const Model& model, std::ostream& out);

/// Plants that have a consistent initial state. All time bounds are multiples of 1 s.
rc::Gen<Model> models(Shape shape = {});

/// Plants of two like halves: each of `models(shape)` beside a copy of it, now and then joined by constraints that say
/// of either half what they say of the other. They can be without a consistent initial state.
rc::Gen<Model> mirrored(Shape shape = {});

/// Plants of some plants of `models(shape)`, so many at least and at most, that have nothing to do with each other.
rc::Gen<Model> side_by_side(Shape shape, std::size_t least, std::size_t most);

/// Constraints over some of the variables of a table, without clocks. `variables` is not empty.
rc::Gen<automata::Formula> formulas(const automata::Variables& table, std::vector<automata::VariableId> variables,
                                    int depth = 2);

/// All variables of a plant: mode variables and attributes.
std::vector<automata::VariableId> all_variables(const automata::Plant& plant);
/// Some values for some of the variables of a table.
rc::Gen<std::vector<automata::Assignment>> partial_assignments(const automata::Variables& table);
rc::Gen<automata::Modes> modes_of(const automata::Plant& plant);
/// All idle, or one control off idle.
rc::Gen<automata::ControlAction> actions_of(const automata::Plant& plant);

/// One line of a log: what was in force up to `time`, and what is seen then.
struct LogLine {
  automata::Ticks time;
  automata::ControlAction action;
  automata::Observation observation;
};
struct Log {
  std::vector<LogLine> lines;
};
void showValue(const Log& log, std::ostream& out);

/// Logs of a plant: mostly what a random run of it shows, with a wild observation now and then.
rc::Gen<Log> logs(const automata::Plant& plant, std::size_t max_length);

/// The same with lines that come again, up to `most` times each: the command and the readings of the line before, after
/// as long a time.
rc::Gen<Log> resting_logs(const automata::Plant& plant, std::size_t max_length, std::size_t most);

/// A program over a plant's variables, as automata: any tree of locations, any arcs, whatever the compiler would emit.
struct RandomProgram {
  automata::Program program;
};
void showValue(const RandomProgram& program, std::ostream& out);
rc::Gen<RandomProgram> programs(const automata::Plant& plant);
/// The same, with branches of `each`, goals of any form, and conditions that ask of the executive's knowledge.
rc::Gen<RandomProgram> programs_that_know(const automata::Plant& plant);

/// A program over a plant's variables, as text and as a tree.
struct RandomSource {
  reference::Rmpl source;
  std::string text;
};
void showValue(const RandomSource& source, std::ostream& out);
rc::Gen<RandomSource> sources(const automata::Plant& plant);

/// What a sequencer is told cycle by cycle: modes that mostly stay as they are, and some observations.
rc::Gen<std::vector<std::vector<automata::Assignment>>> knowledge_of(const automata::Plant& plant, std::size_t cycles);

}  // namespace rmpl::property
