// Whether an island can hold under modes, and a command where it is known, told by the few modes that this depends on.
//
// A command fixes most of what an island says: of ten cells that may write one word, the nine whose turn it is not
// write nothing, whatever their modes. So for each command the constraints are folded with its values, and what always
// finds a value is taken away (elimination.hpp); the answer depends on what the rest reads.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/store/memory.hpp"
#include "automata/store/support.hpp"

namespace rmpl::automata {

/// Remembers the answers of one island. Keeps references.
class Consistency {
 public:
  /// `commanded`: whether the command is known; else its controls are attributes of the island, with any values.
  Consistency(const Plant& plant, const PlantIndex& index, const Island& island, Locality::Commanded commanded);

  /// The remembered answer, or `ask()`, which is then remembered. The action is looked at where it is known.
  template <class Ask>
  bool find(const Modes& modes, const ControlAction& action, const Ask& ask) {
    Answers& answers = of(action);
    return answers.total || answers.known.find(modes, action, ask);
  }

 private:
  struct Answers {
    bool total;  ///< nothing contradicts the island under this command
    Memory<bool> known;
  };
  Answers& of(const ControlAction& action);
  [[nodiscard]] Answers folded(const std::vector<Assignment>& command) const;

  const Plant& plant_;
  const PlantIndex& index_;
  const Island& island_;
  std::optional<Answers> any_;  ///< of no known command, or of one of too many to look at each
  std::vector<std::optional<Answers>> commanded_;
};

}  // namespace rmpl::automata
