// The store of a model program: what the constraints told by marked locations imply, with commands and readings.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/phca.hpp"
#include "automata/state.hpp"
#include "automata/step/program_rules.hpp"

namespace rmpl::automata {

/// The command of some assignments of commanded variables; the others have their idle values.
Command command_from(const ModelProgram& program, std::span<const Assignment> assignments);

/// Asked about markings by their primitive locations; composites tell nothing. Not for two threads at once. Keeps a
/// reference to the program, and remembers no answers: its theory maintains what follows from one question to the next.
class MarkingStore {
 public:
  /// `conditions`: those that `holds` is asked about.
  MarkingStore(const ModelProgram& program, std::span<const Condition> conditions);

  /// Whether what is told can hold.
  bool possible(const Marking& marking);
  /// Whether it can hold together with the command.
  bool permits(const Marking& marking, const Command& command);
  /// Whether a condition, by position, holds of the store of a marking and a command that permit each other.
  bool holds(std::size_t condition, const Marking& marking, const Command& command);
  /// P_O of semantics 4, of the store without a command.
  double factor(const Marking& marking, const Observation& observation);
  /// Marked locations that contradict each other, or the observation; of a marking for which that is so.
  Marking conflict(const Marking& marking, const Observation& observation);
  /// The values that the store of a possible marking entails, by variable.
  std::vector<Assignment> values(const Marking& marking);

  [[nodiscard]] std::size_t questions() const { return theory_.questions(); }
  [[nodiscard]] std::size_t solver_calls() const { return theory_.solver_calls(); }

 private:
  std::vector<Assignment> told(const Marking& marking) const;
  std::vector<Assignment> told(const Marking& marking, const Command& command) const;

  const ModelProgram& program_;
  std::vector<std::optional<VariableId>> selectors_;  ///< per location: the variable under which it is told
  Theory theory_;
  std::vector<std::pair<Theory::Handle, bool>> conditions_;  ///< with whether they ask for entailment
};

}  // namespace rmpl::automata
