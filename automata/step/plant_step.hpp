// One step of a TCCA (semantics 3; thesis Fig. 6-6, 6.2.2): the rules, over the store, with a memory.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/step/transition_rules.hpp"
#include "automata/store/constraint_store.hpp"
#include "automata/store/standing_answers.hpp"
#include "base/bounded_cache.hpp"

namespace rmpl::automata {

/// The sets of enabled transitions that were met, each once.
class EnabledSets;

/// What is enabled in a state, by component. It keeps what it refers to.
class AllEnabled {
 public:
  [[nodiscard]] std::size_t size() const { return sets_.size(); }
  [[nodiscard]] const Enabled& operator[](std::size_t component) const { return *sets_[component]; }
  [[nodiscard]] const Enabled& front() const { return *sets_.front(); }

 private:
  friend class PlantStep;
  std::vector<const Enabled*> sets_;
  std::shared_ptr<const EnabledSets> from_;
};

/// The step function of a plant: the rules (transition_rules.hpp) over its constraint store (constraint_store.hpp),
/// with a bounded memory of whole states. Not for use from two threads at once. Keeps a reference to the plant. What a
/// search found is checked apart from all this by `PlainStep`.
class PlantStep {
 public:
  explicit PlantStep(const Plant& plant);

  [[nodiscard]] const Plant& plant() const { return store_.plant(); }
  [[nodiscard]] ConstraintStore& store() { return store_; }
  /// The store as one theory, for questions that nothing here answers.
  Theory& theory() { return store_.theory(); }
  [[nodiscard]] const Locality& locality() const { return store_.locality(); }
  /// What the enabled transitions of a component in a mode depend on.
  [[nodiscard]] const Support& support(ComponentId component, ModeId mode) const {
    return supports_[component.index()][mode.index()];
  }
  /// The same where store and command are consistent: fewer, as the command and what single modes tell link nothing.
  [[nodiscard]] const Support& commanded_support(ComponentId component, ModeId mode) const {
    return commanded_supports_[component.index()][mode.index()];
  }
  /// A transition that can be taken, with the parts of its guard.
  struct Exit {
    TransitionId transition;
    std::vector<ConstraintStore::Part> parts;
  };
  /// What can be taken out of a mode.
  [[nodiscard]] const std::vector<Exit>& exits(ComponentId component, ModeId mode) const {
    return exits_[component.index()][mode.index()];
  }

  // What the store answers (constraint_store.hpp).
  bool possible(const Modes& modes) { return store_.possible(modes); }
  std::vector<ComponentId> conflict(const Modes& modes) { return store_.conflict(modes); }
  bool consistent(const Modes& modes, const ControlAction& action) { return store_.consistent(modes, action); }
  double observation_factor(const Modes& modes, const Observation& observation) {
    return store_.observation_factor(modes, observation);
  }
  /// Whether store and observations are jointly consistent: the factor without its 1/m.
  bool explains(const Modes& modes, const Observation& observation) {
    return store_.observation_factor(modes, observation) > 0;
  }
  Refutation refutation(const Modes& modes, const Observation& observation) {
    return store_.refutation(modes, observation);
  }
  [[nodiscard]] std::size_t questions() const { return store_.questions(); }
  [[nodiscard]] std::size_t solver_calls() const { return store_.solver_calls(); }

  /// What the store of `modes` and the control action enable for one component; they must be consistent. Modes and
  /// controls outside `support` are not looked at. The reference lasts until the next question about what is enabled.
  const Enabled& enabled(ComponentId component, const Modes& modes, const ControlAction& action);
  /// Per component, what the store of `modes` and the control action enable. The reference lasts until the next call.
  const AllEnabled& enabled(const Modes& modes, const ControlAction& action);
  /// The same, or null where they are not consistent.
  const AllEnabled* enabled_if_permitted(const Modes& modes, const ControlAction& action);
  /// `consistent`, at no cost where `enabled` is asked the same.
  bool permits(const Modes& modes, const ControlAction& action);

  /// What `component` may do in the step that ends at `now`, the step before having ended at `before`, as far as a
  /// double can tell: `moves_of` without what is less probable than the least normal double, which no estimate and no
  /// draw can follow. The probabilities sum to 1.
  [[nodiscard]] std::vector<Move> moves(ComponentId component, ModeId mode, const Enabled& enabled, Ticks clock_start,
                                        Ticks before, Ticks now) const;
  /// `moves` for every component of a state. The reference lasts until the next call.
  const std::vector<std::vector<Move>>& moves(const SystemState& state, const ControlAction& action, Ticks before,
                                              Ticks now);
  /// The probability of going from `state` to exactly `next` (modes, and the clocks that follow from them), before
  /// the consistency of `next` is looked at. It may be too small for a double: whether the step is possible is for
  /// `leads`.
  double probability(const SystemState& state, const ControlAction& action, Ticks before, Ticks now, const Modes& next);
  /// Whether a step can lead from `state` to exactly `next`, however improbable, before the consistency of `next` is
  /// looked at.
  bool leads(const SystemState& state, const ControlAction& action, Ticks before, Ticks now, const Modes& next);
  /// The system state after moving to `next` at `now` under the action (`automata::advance`).
  SystemState advance(const SystemState& state, const ControlAction& action, const Modes& next, Ticks now);
  /// Per component, whether a restart starts its clock anew in the step from there. Lasts until the next call.
  const std::vector<bool>& restarted(const Modes& modes, const ControlAction& action);
  /// Per component, the initial moves: modes with positive initial probability.
  [[nodiscard]] std::vector<std::vector<Move>> initial_moves() const;

 private:
  /// What is known of a whole state under a control action.
  struct Whole {
    bool consistent;
    AllEnabled enabled;
  };

  template <class Implied>
  const Enabled& sort_out(ComponentId component, ModeId mode, Implied&& implied);
  Whole work_out(const Modes& modes, const ControlAction& action);
  const Whole& whole(const Modes& modes, const ControlAction& action);

  ConstraintStore store_;
  std::vector<std::vector<Support>> supports_;            ///< per component, per mode
  std::vector<std::vector<Support>> commanded_supports_;  ///< likewise
  std::vector<std::vector<std::vector<Exit>>> exits_;     ///< per component, per mode: what can be taken out of it
  std::shared_ptr<EnabledSets> sets_;
  bool has_restarts_;
  std::vector<bool> restarted_;              ///< the last answer of `restarted`
  StandingAnswers<const Enabled*> enabled_;  ///< by component, in a consistent store
  std::vector<std::uint64_t> found_;         ///< a set of exits, kept for its memory

  /// Whole states are remembered too: a plant at rest asks the same again and again.
  struct StateAction {
    Modes modes;
    ControlAction action;
    bool operator==(const StateAction&) const = default;
  };
  struct StateActionHash {
    std::size_t operator()(const StateAction& key) const noexcept;
  };
  base::BoundedCache<StateAction, Whole, StateActionHash> wholes_;
  StateAction asked_;  ///< the last question, kept for its memory

  /// The last answer of `moves`: what rests on no clock holds for every state that enables the same.
  struct Moved {
    AllEnabled enabled;
    Ticks step;
    std::vector<std::vector<Move>> moves;
  };
  Moved moved_;
};

}  // namespace rmpl::automata
