// A plant beside an observer, as a symbolic transition system.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "verifier/behaviour/situation.hpp"
#include "verifier/cut_set/fault_sets.hpp"
#include "verifier/plant/mode_ranks.hpp"
#include "verifier/plant/observer.hpp"
#include "verifier/plant/time_left.hpp"
#include "verifier/search/standstill.hpp"
#include "verifier/search/system.hpp"
#include "verifier/symmetry/symmetry.hpp"

namespace rmpl::verifier {

/// By what a run may go on, so that it is not cut off: by any free command, or with all controls idle.
enum class GoesOn { somehow, idle };

/// A state is what a step leads to, closed under waiting: every step starts from it at once. Where part of a zone may
/// wait and part may not (a clock is already beyond an exit's upper bound), they are separate states. Of states that a
/// symmetry makes alike, one is visited.
///
/// Clocks, in this order: the observer's stopwatch where it runs, then those of the live components.
class PlantSystem : public TransitionSystem {
 public:
  /// Keeps references. `start` are the modes to start in.
  PlantSystem(Situations& situations, Observer observer, const Symmetry& symmetry,
              const std::vector<automata::Modes>& start);
  /// From here on `SymbolicState::faults` is a number of these sets. There must be no symmetry.
  void tell_faults_apart(FaultSets& sets) { sets_ = &sets; }
  /// From here on states from which a target comes too late are left out; the stopwatch runs from the start. Keeps a
  /// reference.
  void leave_out_late(const TimeLeft& time_left) { time_left_ = &time_left; }
  /// From here on a clock tells whether time passes in a state before the step out of it, and states are marked where
  /// it has; zones are abstracted, so that there are finitely many. The observer is to have no stopwatch.
  void watch_progress() { progress_ = true; }
  /// From here on timers are folded, as they are in the situations. There must be no symmetry. Labels of states are not
  /// told. Keeps a reference.
  void fold(Folds& folds) { folds_ = &folds; }
  /// From here on a run is cut off where it cannot go on like this.
  void goes_on(GoesOn how) { goes_on_ = how; }
  [[nodiscard]] bool watches_progress() const { return progress_; }

  void initial(const Visit& visit) override;
  void successors(const SymbolicState& state, const Visit& visit) override;
  [[nodiscard]] bool accepts(const SymbolicState& state) const override;
  [[nodiscard]] bool no_more_faults(unsigned a, unsigned b) const override;
  [[nodiscard]] unsigned fault_count(unsigned faults) const override;
  [[nodiscard]] FaultMeasures fault_measures(unsigned faults) const override;
  [[nodiscard]] std::uint32_t rank(std::uint64_t discrete) override;
  void limits(std::uint64_t discrete, std::vector<ClockLimits>& result) override;

  /// A discrete part, taken apart.
  static SituationId situation_of(std::uint64_t discrete) { return SituationId(discrete >> phase_bits); }
  static Phase phase_of(std::uint64_t discrete) { return static_cast<Phase>(discrete & (progressed_bit - 1)); }
  /// Whether time passed before the step that led here.
  static bool progressed(std::uint64_t discrete) { return (discrete & progressed_bit) != 0; }

  /// Where runs are cut off in states that have been seen by a search.
  [[nodiscard]] const CutOff& cut_off() const { return cut_off_; }

  /// `Label::move` of a state in which a run is cut off: its zone is where.
  static constexpr std::uint32_t no_move = UINT32_MAX;
  /// `Label::wait` of a state that has not waited; else it is a position in `Situation::waits`. `Label::move` is a
  /// position in the moves of the state it comes from, or, of an initial state, in the modes to start in.
  static constexpr std::uint32_t no_wait = UINT32_MAX;

  /// A state before symmetry is made use of.
  struct Entered {
    SituationId id;
    std::shared_ptr<const Situation> situation;
    Phase phase;
    unsigned faults;
    Zone zone;
    Label label;
    bool progressed = false;
  };
  using VisitEntered = base::FunctionRef<void(Entered&&)>;
  void enumerate_initial(const VisitEntered& visit);
  void enumerate_successors(const SymbolicState& state, const VisitEntered& visit);
  /// Those by one move, or by `no_move`.
  void enumerate_successors(const SymbolicState& state, std::uint32_t move, const VisitEntered& visit);
  /// The state that is visited in its place; `applied`, where wanted, becomes the permutation that leads there.
  SymbolicState sorted(Entered&& entered, Permutation* applied);

  /// How many faults may still happen.
  [[nodiscard]] unsigned faults_left(const SymbolicState& state) const;
  /// The components that may be late in the state.
  [[nodiscard]] Late late(const SymbolicState& state);

  /// Whether a clock of no component comes first there.
  [[nodiscard]] bool has_extra(Phase phase) const { return progress_ || observer_.timed(phase); }

  [[nodiscard]] Situations& situations() { return situations_; }
  [[nodiscard]] const Observer& observer() const { return observer_; }

 private:
  static constexpr std::size_t stopwatch = 1;  ///< the clock of the observer, where it is timed
  static constexpr unsigned phase_bits = 4;
  static constexpr std::uint64_t progressed_bit = 8;
  static std::uint64_t discrete_of(SituationId situation, Phase phase, bool progressed) {
    return (std::uint64_t{situation.value} << phase_bits) | (progressed ? progressed_bit : 0) |
           static_cast<std::uint64_t>(phase);
  }

  /// The situation of a state with what is needed to speak of its clocks.
  struct Place {
    const Situation& situation;
    bool timed;  ///< an extra clock comes first
    [[nodiscard]] std::size_t clock_of(automata::ComponentId component) const;
  };

  /// Visits what the move at a position leads to.
  void take(const SymbolicState& state, const std::shared_ptr<const Situation>& here, std::uint32_t number,
            const JointStep& move, const VisitEntered& visit);
  [[nodiscard]] bool misses(const Zone& zone, const JointStep& move, const Place& place) const;
  [[nodiscard]] bool pass(Zone& zone, const JointStep& move, const Place& place) const;
  /// Visits the state entered with `zone`, as it is when it has waited in each way that it can.
  void enter(SituationId id, std::shared_ptr<const Situation> situation, Phase phase, unsigned faults, Zone zone,
             Label label, const VisitEntered& visit, bool progressed = false) const;
  /// The same where timers were folded in the situation that a step came from.
  void enter_unfolded(const Situation& from, SituationId id, std::shared_ptr<const Situation> situation, Phase phase,
                      unsigned faults, Zone zone, Label label, const VisitEntered& visit) const;
  [[nodiscard]] Late late(const Situation& situation, const Place& place, const Zone& zone) const;
  [[nodiscard]] static bool within(Zone& zone, const Box& box, const Place& place);
  /// Time passes within the box of a wait, a unit at least where clocks restart in it.
  [[nodiscard]] static bool wait(Zone& zone, const Box& box, const std::vector<automata::ComponentId>& restarted,
                                 const Place& place);
  [[nodiscard]] bool in_time(Zone& zone, Phase phase, const Situation& situation) const;
  /// What the observer comes to there; its formulas are evaluated once for a situation.
  [[nodiscard]] Phase next(Phase phase, SituationId id, const Situation& situation);
  [[nodiscard]] bool is_spent(const SymbolicState& state) const;
  [[nodiscard]] bool may_wait_for_ever(const SymbolicState& state) const;
  void abstract(SymbolicState& state);

  // Where runs are cut off (plant_ends.cpp):
  void enter_end(const std::shared_ptr<const Situation>& here, SituationId id, Phase phase, const SymbolicState& state,
                 const std::vector<JointStep>& moves, const VisitEntered& visit);
  /// Whether there is.
  bool enter_end(SituationId id, Phase phase, unsigned faults, const Zone& zone, const VisitEntered& visit);
  /// The live components that may be at the bound up to which they stay, or beyond.
  [[nodiscard]] static Late due_in(const Situation& situation, const Place& place, const Zone& zone);
  [[nodiscard]] static std::optional<ClockBound> worth_a_cut(const Place& place, const Zone& zone);
  [[nodiscard]] bool plainly_goes_on(const Place& place, const Zone& zone, const std::vector<JointStep>& moves) const;
  [[nodiscard]] bool answered_in(const Standstill& found, Phase phase) const;

  Situations& situations_;
  Observer observer_;
  const Symmetry& symmetry_;
  mutable CutOff cut_off_;
  bool progress_ = false;                ///< time that passes is told
  FaultSets* sets_ = nullptr;            ///< none: faults are counted
  const TimeLeft* time_left_ = nullptr;  ///< none: nothing is known of it
  GoesOn goes_on_ = GoesOn::somehow;
  Folds* folds_ = nullptr;  ///< none: timers are modes
  const std::vector<automata::Modes>& start_;
  ModeRanks ranks_;
  std::vector<std::size_t> sources_;        ///< of the step at hand; its memory serves the next
  std::vector<std::optional<Phase>> next_;  ///< by situation, while the observer owes nothing and while it does
};

}  // namespace rmpl::verifier
