// The names of a scenario, as its plant has them: modes, readings, commands.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "automata/scenario.hpp"
#include "compiler/check/plant_resolver.hpp"
#include "compiler/lower/part.hpp"
#include "grammar/ast/scenario.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// Nothing is found where it is wrong, which is reported. Keeps references.
class ScenarioNames {
 public:
  ScenarioNames(const Part& plant, grammar::Diagnostics& diagnostics);

  /// The mode that a component is in at first. Of software also by what one mode alone tells of those it may start in.
  std::optional<automata::Assignment> start_mode(const grammar::AssignmentText& text);
  /// The mode that a component is forced into, without time and place. Of software also by what fault modes of one
  /// thread tell.
  std::optional<automata::ForcedMode> fault(const grammar::AssignmentText& text);
  std::optional<automata::Assignment> reading(const grammar::AssignmentText& text);
  std::optional<automata::Assignment> command(const grammar::AssignmentText& text);
  std::optional<automata::Formula> condition(const grammar::Constraint& constraint);
  /// As of `PlantResolver`.
  void ask_of_knowledge(std::optional<std::string> refused) { resolver_.ask_of_knowledge(std::move(refused)); }
  /// A command is judged by control variables, an estimate by modes.
  void check_trigger(const automata::Formula& trigger, bool command, const grammar::Constraint& text);

 private:
  enum class Moment { start, fault };
  std::vector<automata::Assignment> modes(const grammar::AssignmentText& text, Moment moment);
  [[nodiscard]] std::vector<automata::Assignment> telling(automata::Assignment told, Moment moment) const;
  void report_several(const grammar::AssignmentText& text, automata::Assignment told,
                      const std::vector<automata::Assignment>& telling);
  void report_no_control(automata::VariableId id, grammar::Span span);
  void note_domain(grammar::Diagnostic& error, automata::VariableId id);

  const Part& part_;
  const automata::Plant& plant_;
  grammar::Diagnostics& diagnostics_;
  PlantResolver resolver_;
  std::unordered_map<automata::VariableId, automata::ComponentId> components_;  ///< by mode variable
  std::unordered_set<automata::VariableId> observables_;
  std::unordered_set<automata::VariableId> controls_;
};

}  // namespace rmpl::compiler
