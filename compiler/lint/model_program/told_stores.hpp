// What the stores of a model program may entail, whichever locations are marked and whatever is commanded.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "automata/phca.hpp"
#include "base/partition.hpp"
#include "compiler/lint/model_program/entailment.hpp"
#include "compiler/lint/program/reachable_locations.hpp"

namespace rmpl::compiler {

/// What contradicts itself: locations by what they tell, and constraints that stand, by position. Few of both.
struct ToldContradiction {
  std::vector<automata::LocationId> told;
  std::vector<std::size_t> standing;
};

/// Threads are taken for independent: any marked locations may be so together where what they tell is consistent. A
/// program that declares neither controls nor what is observed is a library, whose variables may be ports: anything may
/// be told of them. Keeps a reference to the program.
class ToldStores {
 public:
  explicit ToldStores(const automata::ModelProgram& program);

  /// What a condition may be, where only these locations are ever marked.
  Freedom freedom(const automata::Condition& condition, const std::vector<bool>& marked);
  /// What of the constraints that stand is a contradiction; nothing where they can hold.
  std::optional<ToldContradiction> contradiction();
  /// Of locations that are marked together, what of them and of what stands is a contradiction; nothing where they can
  /// hold. Where what stands is none by itself.
  std::optional<ToldContradiction> contradiction(const std::vector<automata::LocationId>& together);
  /// Whether anything that is told or stands speaks of the variable, or it may be told as it comes.
  bool is_spoken_of(automata::VariableId variable);

 private:
  /// What belongs to a part of the variables.
  struct Members {
    std::vector<automata::VariableId> variables, free;
    std::vector<std::size_t> standing;  ///< constraints, by position
    std::vector<automata::LocationId> told;
  };
  void list_members();
  std::optional<ToldContradiction> contradiction_in(const std::vector<automata::Assignment>& selected);
  Entailment& entailment_of(const automata::Formula& formula);

  const automata::ModelProgram& program_;
  std::vector<automata::VariableId> free_;                          ///< that anything may be told of
  std::vector<bool> spoken_of_;                                     ///< per variable: something speaks of it itself
  base::Partition parts_;                                           ///< of the variables, by what is told and stands
  std::map<std::size_t, Members> members_;                          ///< by the part's root
  std::vector<std::optional<automata::VariableId>> selectors_;      ///< per location: under which it is told
  std::vector<automata::Assignment> standing_;                      ///< per constraint: its selector, selected
  automata::Theory together_;                                       ///< all that stands and is told, under selectors
  std::map<std::string, std::unique_ptr<Entailment>> entailments_;  ///< by text
};

}  // namespace rmpl::compiler
