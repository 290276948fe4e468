// What each component can come to from a state, looked at one by one: too much at most, never too little.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/state.hpp"
#include "runtime/reasoning/nominal/closures.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/goal.hpp"

namespace rmpl::runtime {

/// Components are looked at one by one, others in any mode that they can come to themselves: nothing that a plan can
/// reach is left out, and what hangs behind a failed driver is out of reach. An irreversible step counts where the goal
/// names a mode that it leads to, or where it may come with all controls idle. Cost: about the preconditions of the
/// transitions out of what is reached. Keeps references.
class ReachableModes {
 public:
  ReachableModes(const NominalGraph& graph, const automata::Modes& modes, const Goal& goal);

  /// Whether the component can be brought to the mode: only one that the goal names by irreversible steps.
  [[nodiscard]] bool contains(automata::ComponentId c, automata::ModeId m) const {
    return freely_[c.index()][m.index()] || (passed_[c.index()][m.index()] && goal_.named()[c.index()][m.index()]);
  }
  /// Whether it takes an irreversible step to get there.
  [[nodiscard]] bool is_irreversible(automata::ComponentId c, automata::ModeId m) const {
    return !freely_[c.index()][m.index()];
  }

  /// Why a component does not get out of what it passes towards any of the wanted modes: a transition that would lead
  /// on, and is forbidden, or has a requirement that nothing in reach meets. Null transition: none leads there.
  struct Barrier {
    const NominalTransition* transition = nullptr;
    const Requirement* requirement = nullptr;  ///< null: the transition is forbidden
  };
  [[nodiscard]] Barrier barrier(automata::ComponentId component, const std::vector<bool>& wanted) const;

 private:
  const NominalGraph& graph_;
  const Goal& goal_;
  Reached passed_;  ///< with irreversible steps that the goal licenses
  Reached freely_;  ///< without them
};

}  // namespace rmpl::runtime
