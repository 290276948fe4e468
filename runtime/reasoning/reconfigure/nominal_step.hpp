// What a control action does where nothing fails: the nominal successors of a state, and what they cost.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/aftermath.hpp"
#include "runtime/reasoning/reconfigure/drift.hpp"
#include "runtime/reasoning/reconfigure/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/parts.hpp"
#include "runtime/reasoning/reconfigure/reason.hpp"

namespace rmpl::runtime {

/// One nominal transition of one component.
struct NominalMove {
  automata::ComponentId component;
  const NominalTransition* transition;
};

/// One way a step may go.
struct NominalOutcome {
  automata::Modes modes;
  std::vector<NominalMove> moves;  ///< by component; those that change nothing are left out
};

/// A control action by the controls that are off their idle values, ascending, with their values.
using OffIdle = std::vector<std::pair<std::size_t, automata::ValueId>>;

/// The nominal part of semantics 3 for one part of the plant, without clocks: enabled untimed transitions are taken,
/// enabled timed ones may fire or not. Enabledness is asked of `PlantStep`.
class NominalStep {
 public:
  NominalStep(automata::PlantStep& step, const NominalGraph& graph, const Parts& parts);

  [[nodiscard]] const automata::Plant& plant() const { return step_.plant(); }
  /// Whether the store of the modes tolerates the action.
  bool tolerates(const automata::Modes& modes, const automata::ControlAction& action) {
    return step_.permits(modes, action);
  }

  /// Why the last action that was asked about was not permitted, where that was the reason.
  [[nodiscard]] const std::optional<TransitionOf>& refused() const { return refused_; }

  /// The step in which a component takes the given transition under the action: of the others each takes its heaviest
  /// enabled untimed transition (the first of several), and no timed one fires. Nothing where the transition is not
  /// enabled, the step would end in an impossible state, or the action takes or risks a step that is not permitted
  /// (`permits`). With `keep`, also nothing where the action moves another component away from its mode there.
  std::optional<NominalOutcome> take(const automata::Modes& modes, const automata::ControlAction& action,
                                     NominalMove move, const Permitted& permitted, const automata::Modes* keep);

  /// Adds to a step of one part what goes on in the others meanwhile: each of their components takes its heaviest
  /// enabled untimed transition, or a part goes some other way where that one is impossible. Whether there is a way.
  bool join_others(const automata::Modes& modes, const automata::ControlAction& action, std::size_t part,
                   NominalOutcome& outcome);

  /// The timed nominal transitions with an upper bound that end modes of components of the part while the action is
  /// held; none where the modes do not tolerate it.
  std::vector<NominalMove> fleeting(const automata::Modes& modes, const automata::ControlAction& action,
                                    std::size_t part);
  /// What untimed transitions of the part make of the modes.
  std::vector<Consequence> aftermath(const automata::Modes& modes, std::size_t part) {
    return runtime::aftermath(modes, parts_.components(part), step_);
  }

  /// Where the part may come in one step because of the action: what is left at once with something that idling does
  /// not enable, and where a timed transition leads that it does not, by itself and after what is left at once.
  std::vector<automata::Modes> let_come(const automata::Modes& modes, const automata::ControlAction& action,
                                        std::size_t part);

  /// Whether an untimed nominal transition ends the component's mode in the step in which the action is in force.
  bool springs_back(const automata::Modes& modes, const automata::ControlAction& action,
                    automata::ComponentId component);

  /// A state with all controls idle: the values of modes and controls, by variable.
  struct Rest {
    std::vector<automata::ValueId> values;
    bool tolerated;
  };
  Rest rest(const automata::Modes& modes);
  /// Whether the action may enable other nominal transitions than idling does, or the state does not tolerate idling.
  /// Where not, it leads to nothing that idling does not lead to. Read off the preconditions, of the transitions that
  /// ask for what is off idle: no question to the store. The state is consistent.
  bool matters(Rest& rest, const OffIdle& off) const;

  /// Every way a step may go in the part, where the action risks nothing that is not permitted: each combination of
  /// untimed transitions, where some are enabled; else each timed transition by itself. Those that change nothing are
  /// left out.
  std::vector<NominalOutcome> outcomes(const automata::Modes& modes, const automata::ControlAction& action,
                                       std::size_t part, const Permitted& permitted);

 private:
  const NominalTransition& nominal(automata::ComponentId component, automata::TransitionId id) const;
  /// The heaviest of the enabled untimed transitions, the first of several; null where there is none.
  const NominalTransition* heaviest(automata::ComponentId component, const automata::Enabled& enabled) const;
  /// Each combination of enabled untimed transitions of the part, in order of components, then transitions,
  /// impossible ones too; with `fixed`, those that it is part of.
  std::vector<NominalOutcome> combinations(const automata::Modes& modes, const automata::AllEnabled& enabled,
                                           std::size_t part, std::optional<NominalMove> fixed) const;
  /// Whether all that the action enables, idling does not, and the model does not exclude, may be taken, or may come by
  /// itself anyway. A step that cannot be undone is left to chance neither as a side effect nor as the other branch of
  /// an intended one. With `keep`, no other component than the intended one leaves its mode there.
  bool permits(const automata::Modes& modes, const automata::ControlAction& action, const automata::AllEnabled& with,
               std::size_t part, const Permitted& permitted, std::optional<automata::ComponentId> intended,
               const automata::Modes* keep);

  /// Whether the step may come with all controls idle from there on; what interconnections exclude counts, too.
  bool comes_anyway(const automata::Modes& modes, automata::ComponentId c, const NominalTransition& t);
  /// Whether from the state that a command leads to a forbidden step could come by itself, at once or in time, after
  /// whatever else comes by itself, and could not before.
  bool risks(const automata::Modes& before, const automata::Modes& after, std::size_t part, const Permitted& permitted);
  /// The same where each transition that the action enables by itself leads, timed ones too.
  bool lets_come_a_risk(const automata::Modes& modes, const automata::ControlAction& action, std::size_t part,
                        const Permitted& permitted);
  std::vector<TransitionOf> forbidden_to_come(const automata::Modes& modes, std::size_t part,
                                              const Permitted& permitted);
  std::vector<NominalOutcome> by_itself(const automata::Modes& modes, std::size_t part,
                                        const std::vector<bool>& in_question);
  [[nodiscard]] bool can_risk(automata::ComponentId c, automata::ModeId mode, const Permitted& permitted) const;
  [[nodiscard]] bool is_granted(automata::ComponentId c, const NominalTransition& t, const Permitted& permitted) const {
    return permitted.granted[c.index()][graph_.position(c, t)];
  }

  automata::PlantStep& step_;
  const NominalGraph& graph_;
  const Parts& parts_;
  std::vector<std::vector<NominalMove>> readers_;  ///< by control: the transitions whose preconditions read it
  std::optional<TransitionOf> refused_;
  std::optional<std::pair<automata::Modes, Reached>> drift_;  ///< of the state that was asked about last
};

}  // namespace rmpl::runtime
