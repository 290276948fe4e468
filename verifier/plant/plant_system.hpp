// A plant beside an observer, as a symbolic transition system.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "verifier/plant/fault_sets.hpp"
#include "verifier/plant/mode_ranks.hpp"
#include "verifier/plant/observer.hpp"
#include "verifier/plant/situation.hpp"
#include "verifier/plant/time_left.hpp"
#include "verifier/search/standstill.hpp"
#include "verifier/search/system.hpp"
#include "verifier/symmetry/symmetry.hpp"

namespace rmpl::verifier {

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

  void initial(const Visit& visit) override;
  void successors(const SymbolicState& state, const Visit& visit) override;
  [[nodiscard]] bool accepts(const SymbolicState& state) const override;
  [[nodiscard]] bool no_more_faults(unsigned a, unsigned b) const override;
  [[nodiscard]] unsigned fault_count(unsigned faults) const override;
  [[nodiscard]] std::uint32_t rank(std::uint64_t discrete) override;
  void limits(std::uint64_t discrete, std::vector<ClockLimits>& result) override;

  /// A discrete part, taken apart.
  static SituationId situation_of(std::uint64_t discrete) { return SituationId(discrete >> phase_bits); }
  static Phase phase_of(std::uint64_t discrete) { return static_cast<Phase>(discrete & ((1u << phase_bits) - 1)); }

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
  };
  using VisitEntered = base::FunctionRef<void(Entered&&)>;
  void enumerate_initial(const VisitEntered& visit);
  void enumerate_successors(const SymbolicState& state, const VisitEntered& visit);
  /// The state that is visited in its place; `applied`, where wanted, becomes the permutation that leads there.
  SymbolicState sorted(Entered&& entered, Permutation* applied);

  /// The components that may be late in the state.
  [[nodiscard]] Late late(const SymbolicState& state);

  [[nodiscard]] Situations& situations() { return situations_; }
  [[nodiscard]] const Observer& observer() const { return observer_; }

 private:
  static constexpr unsigned phase_bits = 3;
  static std::uint64_t discrete_of(SituationId situation, Phase phase) {
    return (std::uint64_t{situation.value} << phase_bits) | static_cast<std::uint64_t>(phase);
  }

  /// The situation of a state with what is needed to speak of its clocks.
  struct Place {
    const Situation& situation;
    bool timed;  ///< the stopwatch runs
    [[nodiscard]] std::size_t clock_of(automata::ComponentId component) const;
  };

  /// Visits the state entered with `zone`, as it is when it has waited in each way that it can.
  void enter(SituationId id, std::shared_ptr<const Situation> situation, Phase phase, unsigned faults, Zone zone,
             Label label, const VisitEntered& visit) const;
  [[nodiscard]] Late late(const Situation& situation, const Place& place, const Zone& zone) const;
  [[nodiscard]] static bool within(Zone& zone, const Box& box, const Place& place);
  [[nodiscard]] static bool wait(Zone& zone, const Box& box, const Place& place);
  [[nodiscard]] bool in_time(Zone& zone, Phase phase, const Situation& situation) const;
  /// What the observer comes to there; its formulas are evaluated once for a situation.
  [[nodiscard]] Phase next(Phase phase, SituationId id, const Situation& situation);
  [[nodiscard]] bool is_spent(const SymbolicState& state) const;

  Situations& situations_;
  Observer observer_;
  const Symmetry& symmetry_;
  void enter_end(const std::shared_ptr<const Situation>& here, SituationId id, Phase phase, const SymbolicState& state,
                 const std::vector<JointStep>& moves, const VisitEntered& visit);
  [[nodiscard]] bool plainly_goes_on(const Place& place, const Zone& zone, const std::vector<JointStep>& moves) const;
  [[nodiscard]] bool answered_in(const Standstill& found, Phase phase);

  mutable CutOff cut_off_;
  FaultSets* sets_ = nullptr;            ///< none: faults are counted
  const TimeLeft* time_left_ = nullptr;  ///< none: nothing is known of it
  const std::vector<automata::Modes>& start_;
  ModeRanks ranks_;
  std::vector<std::optional<Phase>> next_;  ///< by situation, while the observer owes nothing and while it does
};

}  // namespace rmpl::verifier
