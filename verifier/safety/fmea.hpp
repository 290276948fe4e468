// Failure modes and their effects, a row a fault (the columns of ECSS-Q-ST-30-02C).
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "automata/program.hpp"
#include "automata/property.hpp"
#include "automata/step/plant_step.hpp"
#include "verifier/verdict/fault_table.hpp"

namespace rmpl::verifier {

/// A property of the mission, with the name that rows call it by.
struct NamedProperty {
  std::string name;
  ProgramProperty property;
  std::optional<automata::PlantProperty::Severity> severity = {};  ///< of the failure that it excludes
};

/// An attribute that the modes imply to be something else, or leave open, once the fault has happened.
struct EffectChange {
  automata::VariableId variable;
  std::optional<automata::ValueId> before, after;  ///< none: the modes leave it open
};

/// An attribute, or the mode of another component, that is something else than without the fault, so long after it.
struct LaterEffect {
  automata::VariableId variable;
  std::optional<automata::ValueId> without, with;  ///< none: the modes leave it open
  automata::Ticks after;
};

/// What a flight with the fault showed beside what it would have been without it, with the same luck: under the same
/// commands until the estimate has the fault; to its end under commands of its own.
struct FlownFault {
  std::uint64_t seed = 0;                           ///< of what the plant draws
  automata::Ticks happened = {};                    ///< at the end of that cycle
  std::vector<LaterEffect> effects = {};            ///< until the estimate has the fault; the first of each variable
  std::vector<automata::Assignment> symptoms = {};  ///< the first readings that there are not without it
  std::optional<automata::Ticks> symptom_after = {};
  std::optional<automata::Ticks> named_after = {};     ///< the estimate has it
  std::optional<automata::Assignment> taken_for = {};  ///< a fault that is none, which was estimated until then
  std::string outcome = {};                            ///< of the cycle that follows, in a word
  std::vector<automata::Assignment> response = {};     ///< commanded in that cycle
  std::optional<automata::Ticks> ended = {};           ///< when the program did
  std::optional<automata::Ticks> ended_without = {};   ///< when it did without the fault, with the same luck
  automata::Ticks until = {};                          ///< the end of the flight
};

/// The verdict of a check under this fault alone.
struct CheckedEffect {
  std::string check;  ///< the name of a property, or how `tcca-check program` asks for it
  bool violated = false;
  bool anyway = false;  ///< it is violated without the fault too
};

struct FailureMode {
  FaultStep fault;
  std::optional<automata::Ticks> earliest;  ///< when it can happen; none: it cannot, or that is not known
  std::vector<EffectChange> next;           ///< as it happens on the soonest run, of attributes
  std::vector<EffectChange> detected;       ///< of these the readings that cannot be what they were: at the end of the
                                            ///< cycle in which it happens
  std::vector<automata::Assignment> response;  ///< what the executive commands in the next cycle that commands anything
  std::vector<std::string> end;                ///< what becomes of the program: outcomes of `program --each-fault`
  std::vector<std::string> violated;           ///< names of the properties that it violates, and that hold without it
  std::optional<automata::PlantProperty::Severity> severity;  ///< the worst of these
  bool fails = false;              ///< it can lose the mission, or keep the program from ending
  std::optional<double> rate;      ///< per hour
  std::optional<double> per_step;  ///< the probability in a step in which its guard holds
  bool decided = false;            ///< else a limit cut the row off
  std::vector<CheckedEffect> checks = {};
  std::optional<FlownFault> flown = {};
  bool flights_cut = false;  ///< a limit or a signal came before it was flown
};

struct FailureModes {
  std::vector<FailureMode> rows;  ///< in declaration order
  std::optional<Limit> limit;
  Progress progress;
  std::optional<automata::Ticks> succeeds = {};  ///< without a fault, at the soonest
  std::optional<automata::Ticks> ended = {};     ///< in the first flight without a fault: when the program did
};

/// The value that the modes imply of a variable, if there is one.
std::optional<automata::ValueId> implied(automata::PlantStep& step, const automata::Modes& modes,
                                         automata::VariableId variable);

/// Each row rests on the table of `program --each-fault`, once for the whole mission and once for each property. Rows
/// are those of the components; none: of all. Throws as `check_each_fault`.
FailureModes failure_modes(const automata::Program& program, automata::PlantStep& step,
                           const std::vector<NamedProperty>& mission, const CheckOptions& options, const Limits& limits,
                           const std::vector<automata::ComponentId>& components = {});

std::string to_text(const automata::Plant& plant, const FailureModes& table);
nlohmann::ordered_json to_json(const automata::Plant& plant, const FailureModes& table);
std::string to_csv(const automata::Plant& plant, const FailureModes& table);
std::string to_html(const Subject& subject, const FailureModes& table);

}  // namespace rmpl::verifier
