// Independent groups of a model program: threads whose markings never influence each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "automata/phca.hpp"
#include "automata/state.hpp"

namespace rmpl::automata {

/// Some threads of a model program as a program of its own, with its own numbering of locations and variables.
struct MarkingGroup {
  ModelProgram program;
  std::vector<LocationId> locations;  ///< in the whole program, ascending; none where all are constraints
  std::vector<VariableId> variables;  ///< likewise
  std::vector<std::size_t> controls;  ///< positions in the whole program's `controls`, ascending
};

/// The finest partition such that, given the command, what one group does depends on itself alone. Linked are: a
/// location, what it tells, what its guards read, what its arcs lead to and what it counts as started; a composite that
/// has arcs or is watched for more than commands, and all that it holds; what is drawn together before time 0; the
/// variables of one conjunct of a constraint for the whole program. A commanded variable that only guards read links
/// nothing. A composite that merely holds threads, as the program itself most often does, links nothing either, and is
/// in every group of theirs.
class MarkingGroups {
 public:
  explicit MarkingGroups(const ModelProgram& program);

  [[nodiscard]] std::size_t size() const { return groups_.size(); }
  [[nodiscard]] const MarkingGroup& operator[](std::size_t group) const { return groups_[group]; }

  /// Variables that have one value only.
  [[nodiscard]] const std::vector<Assignment>& always() const { return always_; }
  /// The part of an observation that is a group's, for all of them. What no group tells anything of is nobody's: it is
  /// as likely in one marking as in another.
  [[nodiscard]] std::vector<Observation> divide(const Observation& observation) const;
  [[nodiscard]] std::vector<Command> divide(const Command& command) const;

 private:
  /// Where a variable is.
  struct Home {
    std::size_t group = 0;
    VariableId variable;  ///< there
  };

  std::vector<MarkingGroup> groups_;
  std::vector<std::optional<Home>> homes_;  ///< per variable; none where no group tells anything of it
  std::vector<Assignment> always_;
};

}  // namespace rmpl::automata
