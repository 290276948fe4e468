// The nominal transitions of each component that can be brought about, which of them can be undone, and what they
// reach. SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "runtime/reasoning/reconfigure/islands.hpp"
#include "runtime/reasoning/reconfigure/support.hpp"

namespace rmpl::runtime {

/// A nominal transition whose guard some state and control action imply.
struct NominalTransition {
  automata::TransitionId id;
  automata::ModeId from, to;
  bool timed = false;
  bool bounded = false;     ///< timed, and due at the latest at some time: what has no upper bound may never happen
  bool repair = false;      ///< leaves a fault mode
  bool reversible = false;  ///< nominal transitions lead back from `to` to `from`: computed, not declared (6.3.1)
  bool possible = false;    ///< some state has mode `to`; else the transition is never taken, whatever enables it
  std::vector<Support> supports;
};

/// Per component, per mode: whether the configuration goal names the mode (6.3.3).
using NamedModes = std::vector<std::vector<bool>>;

/// The modes that a goal names: those that it assigns by an atom `a = m` outside negations. `a != m` names none: what
/// is left open is no reason to do what cannot be undone.
NamedModes named_modes(const automata::Plant& plant, const automata::Formula& goal);

/// Per component, the graph over its modes. Computed once; its cost is that of the supports.
class NominalGraph {
 public:
  NominalGraph(const automata::Plant& plant, const Islands& islands);

  /// In declaration order.
  [[nodiscard]] const std::vector<NominalTransition>& transitions(automata::ComponentId component) const {
    return transitions_[component.index()];
  }
  /// Nothing where the transition is a fault or cannot be brought about.
  [[nodiscard]] const NominalTransition* find(automata::ComponentId component, automata::TransitionId id) const;

  /// Whether reconfiguration may count on a transition: it is timed, can be undone, repairs the fault that it leaves
  /// (no nominal transition enters a fault, so it is the current one), or leads to a mode that the goal names (6.3.3).
  [[nodiscard]] static bool permitted(const NominalTransition& transition, const std::vector<bool>& named) {
    return transition.timed || transition.reversible || transition.repair || named[transition.to.index()];
  }

  /// Per component, per mode: whether permitted transitions lead there from `modes`, each by a support whose modes the
  /// other components reach too: what hangs behind a failed driver is out of reach.
  [[nodiscard]] std::vector<std::vector<bool>> reachable(const automata::Modes& modes, const NamedModes& named) const;

  /// Why a component does not get out of what it reaches towards any of the wanted modes, though its own permitted
  /// transitions lead there.
  struct Obstacle {
    const NominalTransition* transition;  ///< would lead further; to a wanted mode, where there is such a one
    const Requirement* requirement;       ///< that nothing in reach meets, of its simplest support
  };
  [[nodiscard]] std::optional<Obstacle> obstacle(automata::ComponentId component, const std::vector<bool>& wanted,
                                                 const std::vector<std::vector<bool>>& reached,
                                                 const NamedModes& named) const;

  /// The components that may change their mode of themselves: some untimed transition needs no command. While one part
  /// of the plant is commanded, these do not stand still, so their islands are planned together.
  [[nodiscard]] std::vector<automata::ComponentId> restless(const automata::Plant& plant) const;

 private:
  [[nodiscard]] bool meets(const Requirement& requirement, const std::vector<std::vector<bool>>& reached) const;

  std::vector<std::vector<NominalTransition>> transitions_;
  std::vector<std::optional<automata::ComponentId>> component_of_;  ///< by variable
  std::vector<std::vector<automata::ComponentId>> dependents_;      ///< by component: others whose supports read it
};

}  // namespace rmpl::runtime
