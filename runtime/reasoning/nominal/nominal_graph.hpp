// The nominal transitions of each component that can be brought about, which of them can be undone, and what they
// reach.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "automata/dependencies/plant_index.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/store/support.hpp"
#include "runtime/reasoning/nominal/precondition.hpp"

namespace rmpl::runtime {

/// A nominal transition whose guard some state and control action imply.
struct NominalTransition {
  automata::TransitionId id;
  automata::ModeId from, to;
  bool timed = false;
  bool repair = false;           ///< leaves a fault mode, or ends what began so (semantics 5)
  bool reversible = false;       ///< nominal transitions lead back from `to` to `from`: computed, not declared (6.3.1)
  bool irreversible = false;     ///< to strategies (irreversible.hpp)
  bool licensed = false;         ///< of a component of progress: a step forward is what it is for
  bool possible = false;         ///< some state has mode `to`; else the transition is never taken, whatever enables it
  bool comes_by_itself = false;  ///< some precondition asks neither for a command nor for modes of others
  std::vector<Precondition> preconditions;
  bool all_preconditions = true;  ///< whatever consistent state and control action imply the guard fits one of them
  std::vector<bool> silent;       ///< per precondition: it can be met with every control idle
};

/// Per component, per mode: whether the configuration goal names the mode (6.3.3).
using NamedModes = std::vector<std::vector<bool>>;

/// The modes that a goal names: those of its atoms that stand under an even number of negations, an antecedent counting
/// as one; each mode of `a in {...}`. `a != m` names none: what is left open is no reason to do what cannot be undone.
/// Neither does an equivalence, which asks for its sides as much as it forbids them.
NamedModes named_modes(const automata::Plant& plant, const automata::Formula& goal);

/// Per component, the graph over its modes. Computed once; its cost is that of the preconditions.
class NominalGraph {
 public:
  explicit NominalGraph(const automata::Plant& plant);

  /// All of the plant.
  [[nodiscard]] const std::vector<automata::ComponentId>& components() const { return components_; }
  /// How many modes the component has.
  [[nodiscard]] std::size_t mode_count(automata::ComponentId component) const {
    return leads_[component.index()].size();
  }

  /// In declaration order.
  [[nodiscard]] const std::vector<NominalTransition>& transitions(automata::ComponentId component) const {
    return transitions_[component.index()];
  }
  /// Nothing where the transition is a fault or cannot be brought about.
  [[nodiscard]] const NominalTransition* find(automata::ComponentId component, automata::TransitionId id) const;

  /// Its position in `transitions`.
  [[nodiscard]] std::size_t position(automata::ComponentId component, const NominalTransition& transition) const {
    return static_cast<std::size_t>(&transition - transitions_[component.index()].data());
  }

  /// Whether a transition needs no leave: it can be undone, is part of a repair, or is progress (semantics 5).
  [[nodiscard]] static bool harmless(const NominalTransition& transition) {
    return transition.reversible || transition.repair || transition.licensed || transition.from == transition.to;
  }
  /// Whether nominal transitions lead a component from one mode to another; every mode leads to itself.
  [[nodiscard]] bool leads(automata::ComponentId component, automata::ModeId from, automata::ModeId to) const {
    return leads_[component.index()][from.index()][to.index()];
  }
  /// Whether some mode that the goal names can be come to from the mode.
  [[nodiscard]] bool leads_to_named(automata::ComponentId component, automata::ModeId from,
                                    const NamedModes& named) const;

  /// The modes of others and the controls that decide which nominal transitions leave a mode. Nothing where some of
  /// these have more preconditions than are known.
  [[nodiscard]] const std::optional<automata::Support>& deciding(automata::ComponentId component,
                                                                 automata::ModeId mode) const {
    return deciding_[component.index()][mode.index()];
  }
  /// Whether modes and controls that the model tolerates together meet some precondition of the transition.
  [[nodiscard]] bool met(const NominalTransition& transition, const automata::Modes& modes,
                         const automata::ControlAction& action) const;

  /// Others whose preconditions read the component's mode.
  [[nodiscard]] const std::vector<automata::ComponentId>& dependents(automata::ComponentId component) const {
    return dependents_[component.index()];
  }
  /// These, and all that decides whether they move: what their preconditions read, and so on. Each once, in the order
  /// in which it is found.
  [[nodiscard]] std::vector<automata::ComponentId> upstream(std::span<const automata::ComponentId> components) const;
  /// Whether some of the modes reached meet a requirement; one on a control always counts as met.
  [[nodiscard]] bool meets(const Requirement& requirement, const std::vector<std::vector<bool>>& reached) const;
  /// The component whose mode a requirement is about, if it is one.
  [[nodiscard]] std::optional<automata::ComponentId> component_of(const Requirement& requirement) const {
    return index_.component_of(requirement.variable);
  }

 private:
  [[nodiscard]] automata::Support support_of(const std::vector<Precondition>& preconditions) const;

  automata::PlantIndex index_;
  std::vector<automata::ComponentId> components_;
  std::vector<std::vector<NominalTransition>> transitions_;
  std::vector<std::vector<std::vector<bool>>> leads_;                    ///< per component, from, to
  std::vector<std::vector<std::optional<automata::Support>>> deciding_;  ///< per component, per mode
  std::vector<std::vector<automata::ComponentId>> dependents_;  ///< by component: others whose preconditions read it
};

}  // namespace rmpl::runtime
