// Joint steps: what all components do at once, every one of them or only those that nothing else replaces.
//
// In dense time steps follow each other with no time between. A joint step of components that have nothing to do with
// each other can then be taken in several steps at the same instant, and leads to the same state; among n components
// that is n steps in place of 2^n. What is left out here is only what other steps make up for, so that the reachable
// states are exactly the same; the number of steps to them is not.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "base/function_ref.hpp"
#include "verifier/plant/behaviour.hpp"
#include "verifier/plant/joint_choices.hpp"
#include "verifier/plant/nogoods.hpp"
#include "verifier/property/commands.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/symmetry/symmetry.hpp"

namespace rmpl::verifier {

/// Components whose clocks may be past the bound up to which they can stay under idle controls, in dense time;
/// ascending.
using Late = std::vector<automata::ComponentId>;

/// Which joint steps are of interest.
enum class Steps {
  all,
  /// Dense time only: a step is left out where the same state is reached by taking one of its components, or all of
  /// those that the command does not concern, a step earlier or later at the same instant.
  irreducible
};

/// The joint steps from given modes. Keeps references.
class JointSteps {
 public:
  JointSteps(Behaviours& behaviours, unsigned faults, Meter& meter);

  /// Which steps are enumerated from here on; all of them to begin with. `visible` are the components whose modes an
  /// observer reads on the way: none of them is taken earlier or later.
  void use(Steps steps, const std::vector<automata::ComponentId>& visible);

  /// From here on, of steps that differ only in which of several like components does what, one is enumerated: the
  /// states that the others lead to are the same up to symmetry. Keeps a reference.
  void up_to(const Symmetry& symmetry) { symmetry_ = &symmetry; }

  /// A possible step: the modes that it leads to, the faults it costs, and where the clocks must be.
  using Visit = base::FunctionRef<void(const automata::Modes& next, unsigned faults, const Box& bounds)>;

  /// Every step from the possible `modes` under the action that changes a mode; the behaviours there are `idling` with
  /// idle controls, `here` under the action. Where steps are left out, no component but those that are `late` is past
  /// the bound up to which it can stay with idle controls.
  void enumerate(const automata::Modes& modes, const Late& late, const automata::ControlAction& action,
                 const std::vector<BehaviourId>& idling, const std::vector<BehaviourId>& here, const Visit& visit);

 private:
  struct Option {
    std::size_t component;
    const Choice* choice;
  };
  using Options = std::vector<std::vector<Option>>;  ///< of several components, one of each list is taken
  /// Where steps are enumerated from: the arguments of `enumerate`.
  struct At {
    const automata::Modes& modes;
    const Late& late;
    const automata::ControlAction& action;
    const std::vector<BehaviourId>& idling;  ///< with idle controls
    const std::vector<BehaviourId>& here;    ///< under the action
  };

  void all(const At& at, const Visit& visit);
  void irreducible(const At& at, const Visit& visit);
  void rest(const At& at, const std::vector<Option>& core, const Options& free, const Visit& visit);
  [[nodiscard]] static unsigned faults_of(const std::vector<Option>& taken);
  /// Calls `leaf` for every way of taking one of each list, within the faults that are left after `faults`.
  template <class Leaf>
  void product(const At& at, const Options& options, unsigned faults, std::vector<Option>& taken, const Leaf& leaf);
  /// For each list the last one before it whose component can be exchanged with its own, or itself.
  [[nodiscard]] std::vector<std::size_t> likes(const At& at, const Options& options) const;
  void emit(const At& at, const std::vector<Option>& taken, const Visit& visit);
  [[nodiscard]] const automata::Modes& after(const At& at, const std::vector<Option>& taken);
  /// Whether the modes are possible and let every component stay where it is with idle controls; their behaviours with
  /// idle controls are then in `there_`.
  [[nodiscard]] bool calm(const At& at, const automata::Modes& modes);
  [[nodiscard]] bool may_stay(const At& at, std::size_t component, BehaviourId behaviour,
                              const automata::Modes& modes) const;
  [[nodiscard]] bool goes_first(const At& at, const Option& option);

  Behaviours& behaviours_;
  Nogoods nogoods_;
  unsigned faults_;
  const Symmetry* symmetry_ = nullptr;
  Steps steps_ = Steps::all;
  std::vector<bool> visible_;  ///< by component
  Meter& meter_;

  automata::ControlAction idle_;

  // Of the step at hand; their memory serves the next:
  bool calm_ = false;   ///< whether every component may stay where steps are enumerated from
  PartialModes ahead_;  ///< what is decided of the modes that a step leads to
  automata::Modes next_;
  std::vector<BehaviourId> there_, there_commanded_;
  Box box_;
};

}  // namespace rmpl::verifier
