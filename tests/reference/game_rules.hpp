// Which steps cannot be undone, and which of them a goal licenses.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "automata/logic/formula.hpp"
#include "tests/reference/game_step.hpp"

namespace rmpl::reference {

/// Per component, by the graph of the nominal transitions that can be taken at all (`GameStep::can_be_taken`).
///
/// Usual modes are those that nominal transitions lead to from the initial nominal modes. After a fault are the fault
/// modes, and the modes that are not usual and that faults lead to, at once or on the way of a repair. A step is
/// irreversible where no way leads back; one from a mode after a fault, where no way leads from its target to a usual
/// mode from which the fault is entered that led there. One out of a fault that nothing leads into is none.
///
/// A step is licensed where the goal names its target, or a mode that its target leads to.
class Irreversible {
 public:
  /// `progress`: the components that only ever go forward and are meant to.
  Irreversible(GameStep& step, const automata::Formula& goal, const std::set<std::size_t>& progress);

  [[nodiscard]] bool is_irreversible(std::size_t component, automata::ModeId from, automata::ModeId to) const {
    return steps_[component].contains({from, to});
  }
  [[nodiscard]] bool is_licensed(std::size_t component, automata::ModeId to) const {
    return licensed_[component].contains(to);
  }

 private:
  std::vector<std::set<std::pair<automata::ModeId, automata::ModeId>>> steps_;
  std::vector<std::set<automata::ModeId>> licensed_;
};

}  // namespace rmpl::reference
