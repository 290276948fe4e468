// One step of a TCCA: which transitions are enabled and with what probability (semantics 3; thesis Fig. 6-6, 6.2.2).
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/store/island_store.hpp"
#include "automata/store/memory.hpp"
#include "automata/store/standing_answers.hpp"
#include "automata/store/support.hpp"

namespace rmpl::automata {

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

/// What is enabled in a state, by component. What it refers to lasts as long as the `PlantStep` that it is from.
class AllEnabled {
 public:
  [[nodiscard]] std::size_t size() const { return sets_.size(); }
  [[nodiscard]] const Enabled& operator[](std::size_t component) const { return *sets_[component]; }
  [[nodiscard]] const Enabled& front() const { return *sets_.front(); }

 private:
  friend class PlantStep;
  std::vector<const Enabled*> sets_;
};

/// The step function of a plant. It asks the store island by island (support.hpp), and each island remembers what it
/// has proved: a question costs a few look-ups wherever the modes and controls that the islands read have been met
/// before, whatever the rest of the plant does, and else a pass over what propagation derives on one island
/// (truth_maintenance.hpp). Not for use from two threads at once. Keeps a reference to the plant.
class PlantStep {
 public:
  explicit PlantStep(const Plant& plant);

  [[nodiscard]] const Plant& plant() const { return plant_; }
  /// The store of the whole plant, for questions that this class does not answer.
  Theory& theory() { return theory_; }
  [[nodiscard]] const Locality& locality() const { return locality_; }
  /// What the enabled transitions of a component in a mode depend on.
  [[nodiscard]] const Support& support(ComponentId component, ModeId mode) const {
    return supports_[component.index()][mode.index()];
  }

  /// The guard of a transition, as the theory knows it.
  [[nodiscard]] Theory::Handle guard(ComponentId component, TransitionId transition) const {
    return guards_[component.index()][transition.index()];
  }

  /// Whether the store of these modes (Q and the mode constraints) is consistent; else the state is impossible.
  bool possible(const Modes& modes);
  /// Of impossible modes: components whose modes cannot be together, none of which can be spared. A few questions.
  std::vector<ComponentId> conflict(const Modes& modes);
  /// Whether the store is consistent with the control action; else it implies every guard.
  bool consistent(const Modes& modes, const ControlAction& action);
  /// What the store of `modes` and the control action enable for one component; they must be consistent. Modes and
  /// controls outside `support` are not looked at.
  const Enabled& enabled(ComponentId component, const Modes& modes, const ControlAction& action);
  /// Per component, what the store of `modes` and the control action enable. The reference lasts until the next call.
  const AllEnabled& enabled(const Modes& modes, const ControlAction& action);
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
  /// Where they are not: components to blame.
  Refutation refutation(const Modes& modes, const Observation& observation);

  /// How many questions the stores were asked, and how often that took a solver.
  [[nodiscard]] std::size_t questions() const;
  [[nodiscard]] std::size_t solver_calls() const;

  /// Per component, the initial moves: modes with positive initial probability.
  [[nodiscard]] std::vector<std::vector<Move>> initial_moves() const;

 private:
  /// A conjunct of a guard: a formula that one island watches, or one that it takes several islands, or modes, to
  /// judge.
  struct Part {
    std::size_t island;
    std::size_t number;
  };
  static constexpr std::size_t no_island = static_cast<std::size_t>(-1);
  struct Wide {
    Theory::Handle formula;
    Support support;
    Memory<bool> implied;
  };
  /// A transition that can be taken, with the parts of its guard.
  struct Exit {
    TransitionId transition;
    std::vector<Part> parts;
  };
  /// The transitions out of a mode, and each set of them that was found enabled so far, by the bits of its members.
  struct Exits {
    std::vector<Exit> all;
    std::unordered_map<std::vector<std::uint64_t>, Enabled, WordsHash> sets;
  };

  /// What is known of a whole state under a control action.
  struct Whole {
    bool consistent;
    AllEnabled enabled;
  };

  Part part(const Formula& conjunct);
  bool implied(Wide& wide, const Modes& modes, const ControlAction& action);
  template <class Implied>
  const Enabled& sort_out(ComponentId component, ModeId mode, const Implied& implied);
  Whole work_out(const Modes& modes, const ControlAction& action);
  const Whole& whole(const Modes& modes, const ControlAction& action);
  void observe(const Observation& observation);

  const Plant& plant_;
  Locality locality_;
  Theory theory_;
  std::vector<std::vector<Theory::Handle>> guards_;  ///< per component, per transition
  std::vector<std::vector<Support>> supports_;       ///< per component, per mode
  std::vector<std::vector<Exits>> exits_;            ///< per component, per mode
  std::vector<IslandStore> islands_;                 ///< as the locality has them
  std::vector<Wide> wide_;
  std::vector<std::size_t> constrained_;          ///< positions of the islands that can be inconsistent
  StandingAnswers<bool> possible_;                ///< of those
  StandingAnswers<bool> consistent_;              ///< of those
  StandingAnswers<const Enabled*> enabled_;       ///< by component, in a consistent store
  std::vector<std::uint64_t> found_;              ///< a set of exits, kept for its memory
  std::vector<IslandStore::Verdicts*> verdicts_;  ///< by island, of the state that is worked out; null: not asked yet

  /// Whole states are remembered too: a plant at rest asks the same again and again.
  struct StateAction {
    Modes modes;
    ControlAction action;
    bool operator==(const StateAction&) const = default;
  };
  struct StateActionHash {
    std::size_t operator()(const StateAction& key) const noexcept;
  };
  Forgetful<StateAction, Whole, StateActionHash> wholes_;
  StateAction asked_;  ///< the last question, kept for its memory

  std::optional<Observation> observed_;  ///< what the islands were told last
  std::vector<std::size_t> weighed_;     ///< positions of the islands that can be inconsistent or that are observed
  StandingAnswers<double> factors_;      ///< of those
};

}  // namespace rmpl::automata
