// What each component can come to from a state, what it takes, and whether a control has a say in it (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "automata/state.hpp"
#include "runtime/reasoning/reconfigure/drift.hpp"
#include "runtime/reasoning/reconfigure/goal.hpp"
#include "runtime/reasoning/reconfigure/nominal_graph.hpp"

namespace rmpl::runtime {

/// Components are looked at one by one, others through what they can come to themselves: nothing that a plan can reach
/// is left out, and what hangs behind a failed driver is out of reach. Cost: about the preconditions of the transitions
/// out of what is reached.
class Prospects {
 public:
  /// With `keeping`, nothing that a command does may leave what the goal's conjuncts over modes permit.
  Prospects(const NominalGraph& graph, const automata::Modes& modes, const Goal& goal, bool keeping);

  /// Modes that the component can be aimed at; the irreversible steps that it takes. What happens anyway is none, nor
  /// is leaving a fault. Only a mode that the goal names is aimed at by irreversible steps.
  [[nodiscard]] const std::optional<std::uint32_t>& steps(automata::ComponentId c, automata::ModeId m) const {
    return steps_[c.index()][m.index()];
  }
  /// What a goal state takes before all else: irreversible steps, then components moved that are not commandable. Each
  /// of its modes can be aimed at.
  [[nodiscard]] std::pair<std::uint64_t, std::size_t> effort(const automata::Modes& modes,
                                                             const automata::Modes& target) const;
  /// Modes that the component can pass, on the way to one that it can be aimed at.
  [[nodiscard]] const Reached& passed() const { return passed_; }
  /// Modes that it may come to with all controls idle, its own among them.
  [[nodiscard]] const Reached& drift() const { return drift_; }
  /// Whether some control can bring about or prevent the component's next step, directly or through others.
  [[nodiscard]] bool commandable(automata::ComponentId c) const { return commandable_[c.index()]; }

  /// What may be taken on the way to a target: what can be undone, what happens anyway, and irreversible steps of a
  /// component whose target the goal names, on the way to that or to another mode that it names for it.
  [[nodiscard]] Permitted permitted(const automata::Modes& target) const;

  /// Why a component does not get out of what it passes towards any of the wanted modes: a transition that would lead
  /// on, and is forbidden, or has a requirement that nothing in reach meets. Null transition: none leads there.
  struct Barrier {
    const NominalTransition* transition = nullptr;
    const Requirement* requirement = nullptr;  ///< null: the transition is forbidden
  };
  [[nodiscard]] Barrier barrier(automata::ComponentId component, const std::vector<bool>& wanted) const;

 private:
  [[nodiscard]] bool supported(const NominalTransition& t) const;
  [[nodiscard]] bool felt(automata::ComponentId c, const NominalTransition& t) const;
  void count_steps(automata::ComponentId c);
  void find_commandable();

  const NominalGraph& graph_;
  const automata::Modes& modes_;
  const Goal& goal_;
  Reached drift_, passed_;
  std::vector<std::vector<std::optional<std::uint32_t>>> steps_;
  std::vector<bool> commandable_;
};

}  // namespace rmpl::runtime
