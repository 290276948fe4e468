// One step of a TCCA: which transitions are enabled and with what probability (semantics 3; thesis Fig. 6-6, 6.2.2).
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/step/memory.hpp"
#include "automata/step/support.hpp"

namespace automata {

/// What one component may do in one step: go to `mode` (staying is going to its own mode) with `probability` > 0.
struct Move {
  ModeId mode;
  double probability;
};

/// The transitions of one component that its mode and the guards allow; time bounds are not looked at yet.
struct Enabled {
  std::vector<TransitionId> faults;   ///< guard holds, weight above zero
  std::vector<TransitionId> untimed;  ///< nominal, without time bounds, weight above zero
  std::vector<TransitionId> timed;    ///< nominal, with time bounds
};

/// The step function of a plant. Holds one incremental solver and remembers what it has proved, part by part: a
/// question costs a look-up wherever the modes and controls that its answer can depend on (support.hpp) have been met
/// before, whatever the rest of the plant does; a question about a whole state, one look-up where it was met before,
/// and else a pass over what propagation derives from it (truth_maintenance.hpp). Not for use from two threads at once.
/// Keeps a reference to the plant.
class PlantStep {
 public:
  explicit PlantStep(const Plant& plant);

  [[nodiscard]] const Plant& plant() const { return plant_; }
  Theory& theory() { return theory_; }
  [[nodiscard]] const Locality& locality() const { return locality_; }
  /// What the enabled transitions of a component in a mode depend on.
  [[nodiscard]] const Support& support(ComponentId component, ModeId mode) const {
    return parts_[component.index()][mode.index()].support;
  }

  /// The guard of a transition, as the theory knows it.
  [[nodiscard]] Theory::Handle guard(ComponentId component, TransitionId transition) const {
    return guards_[component.index()][transition.index()];
  }

  /// Whether the store of these modes (Q and the mode constraints) is consistent; else the state is impossible.
  bool possible(const Modes& modes);
  /// Of impossible modes: some that cannot be together, none of which can be spared. Asks one question for each.
  std::vector<Assignment> conflict(const Modes& modes);
  /// Whether the store is consistent with the control action; else it implies every guard.
  bool consistent(const Modes& modes, const ControlAction& action);
  /// What the store of `modes` and the control action enable for one component; they must be consistent. Modes and
  /// controls outside `support` are not looked at. The reference lasts until the next call.
  const Enabled& enabled(ComponentId component, const Modes& modes, const ControlAction& action);
  /// Per component, what the store of `modes` and the control action enable. The reference lasts until the next call.
  const std::vector<Enabled>& enabled(const Modes& modes, const ControlAction& action);
  /// `consistent`, at no cost where `enabled` is asked the same.
  bool permits(const Modes& modes, const ControlAction& action);

  /// What `component` may do in the step that ends at `now`, the step before having ended at `before`: every mode with
  /// a positive probability, each once, in order of mode; they sum to 1.
  [[nodiscard]] std::vector<Move> moves(ComponentId component, ModeId mode, const Enabled& enabled, Ticks clock_start,
                                        Ticks before, Ticks now) const;
  /// `moves` for every component of a state.
  std::vector<std::vector<Move>> moves(const SystemState& state, const ControlAction& action, Ticks before, Ticks now);

  /// The probability of going from `state` to exactly `next` (modes, and the clocks that follow from them), before
  /// the consistency of `next` is looked at.
  double probability(const SystemState& state, const ControlAction& action, Ticks before, Ticks now, const Modes& next);

  /// The system state after moving to `next` at `now`: a clock restarts when its mode changes.
  [[nodiscard]] static SystemState advance(const SystemState& state, const Modes& next, Ticks now);

  /// P_O of semantics 4: per observation 1 if the store of `modes` entails it, 0 if it refutes it, 1/m otherwise; 0 if
  /// store and observations are jointly inconsistent (so also where the state itself is impossible).
  double observation_factor(const Modes& modes, const Observation& observation);
  /// Whether store and observations are jointly consistent: the factor without its 1/m.
  bool explains(const Modes& modes, const Observation& observation);

  /// Per component, the initial moves: modes with positive initial probability.
  [[nodiscard]] std::vector<std::vector<Move>> initial_moves() const;

 private:
  /// What is known of one component in one mode.
  struct Part {
    Support support;
    Memory<Enabled> enabled;
  };
  /// What is known of one island: whether it is consistent, in modes and under control actions.
  struct IslandMemory {
    Memory<bool> possible;
    Memory<bool> consistent;
  };

  /// What is known of a whole state under a control action.
  struct Whole {
    bool consistent;
    std::vector<Enabled> enabled;
  };

  [[nodiscard]] std::vector<Assignment> assumptions(const Support& support, const Modes& modes,
                                                    const ControlAction& action) const;
  [[nodiscard]] Enabled work_out(ComponentId component, const Modes& modes, const ControlAction& action);
  /// All that start in the mode and can weigh something, each tested.
  template <class Test>
  [[nodiscard]] Enabled sort_out(ComponentId component, ModeId mode, const Test& test) const;
  [[nodiscard]] Whole work_out(const Modes& modes, const ControlAction& action);
  const Whole& whole(const Modes& modes, const ControlAction& action);
  [[nodiscard]] double work_out(const Modes& modes, const Observation& observation);

  const Plant& plant_;
  Locality locality_;
  Theory theory_;
  std::vector<std::vector<Theory::Handle>> guards_;  ///< per component, per transition
  /// A transition that can be taken, with its guard.
  struct Exit {
    TransitionId transition;
    Theory::Handle guard;
  };
  std::vector<std::vector<std::vector<Exit>>> exits_;  ///< per component, per mode
  std::vector<std::vector<Part>> parts_;               ///< per component, per mode
  std::vector<IslandMemory> islands_;                  ///< by island
  std::vector<std::size_t> constrained_;               ///< positions of the islands that can be inconsistent

  /// Whole states are remembered too: a plant at rest asks the same again and again.
  struct StateAction {
    Modes modes;
    ControlAction action;
    bool operator==(const StateAction&) const = default;
  };
  struct StateActionHash {
    std::size_t operator()(const StateAction& key) const noexcept;
  };
  struct StateObservation {
    Modes modes;
    Observation observation;
    bool operator==(const StateObservation&) const = default;
  };
  struct StateObservationHash {
    std::size_t operator()(const StateObservation& key) const noexcept;
  };
  Forgetful<StateAction, Whole, StateActionHash> enabled_;
  Forgetful<StateObservation, double, StateObservationHash> factors_;
  StateAction asked_;      ///< the last question, kept for its memory
  StateObservation seen_;  ///< likewise
};

}  // namespace automata
