// The closed loop, and what is looked for in it, as a symbolic transition system.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "verifier/closed_loop/loop.hpp"
#include "verifier/closed_loop/step_memory.hpp"
#include "verifier/cut_set/fault_sets.hpp"
#include "verifier/property/fault.hpp"
#include "verifier/search/passed.hpp"
#include "verifier/search/standstill.hpp"
#include "verifier/search/system.hpp"
#include "verifier/witness/undone.hpp"

namespace rmpl::verifier {

/// Which faults may happen, within the budget.
struct FaultFilter {
  bool only = false;               ///< none but `fault`
  std::optional<FaultStep> fault;  ///< if there is one, what is looked for is looked for after it
};

/// What is looked for along the runs of the loop.
struct Query {
  enum class Aim {
    goal_conflict,  ///< a cycle whose goals contradict each other
    no_plan,        ///< a cycle without a plan
    endless_wait,   ///< a wait that may last for ever
    holds,          ///< a state in which `test` holds, while the program runs or as it ends
    late,           ///< `test` has not held when `deadline` is reached; such runs go on after the program's end
    missed,         ///< the same, counted from a state in which `asks` holds, while the program runs or as it ends
                    ///< (of both where there is no deadline: a wait that lasts for ever, or a run that is cut off; a
                    ///< run that goes round is for `find_lasso`)
    ends_with,      ///< the program's end in a state in which `test` holds
    happens,        ///< the fault of the filter
    stop,           ///< where nothing can follow, or time stands still
    undone,         ///< a command for reward has taken away what a goal achieved
    still,          ///< where time stands still
    spent,          ///< more faults are certain than there may be
    nothing         ///< everything is seen
  };
  Aim aim = Aim::nothing;
  std::function<bool(const LoopState&)> test = nullptr;
  std::function<bool(const LoopState&)> asks = nullptr;
  Units deadline = 0;  ///< the fewest units that are too late; `unbounded`: it may come some day
  /// What is at one moment is looked for at these times alone; at any, where it is empty.
  std::optional<Interval> window = std::nullopt;
  FaultFilter filter = {};
  /// Of `no_plan` and `endless_wait`: only such a cycle; any, where it is empty.
  std::function<bool(const LoopState&, const Turn&)> fresh = nullptr;
  /// Dense time: keep a clock that tells whether time passes, and mark the states that it brings.
  bool progress = false;
};

/// Where a run is cut off: what the clocks read as the cycle begins in the state at a position of its path.
struct PathEnd {
  std::size_t position;
  std::optional<Interval> stopwatch;  ///< where the deadline has passed
  Box components;
  std::vector<std::pair<automata::ClockId, Interval>> program;
};

/// A state is the start of a cycle with the clocks in cells, closed under waiting. A cycle is a step, silent where
/// nothing changes but the cells.
///
/// Clocks, in this order: the stopwatch of `late`, `missed` and of a window, the clock of `progress`, the groups of
/// program clocks, the clocks of the live components.
class ProgramSystem : public TransitionSystem {
 public:
  /// Keeps references.
  ProgramSystem(Loop& loop, const std::vector<LoopState>& start, const Query& query);
  /// From now on, what follows a state is looked up there. It is to be one that only searches have used which watch the
  /// same clocks, have as many faults, and mark faults alike (`FaultFilter::only`). Not for *undone*, whose states name
  /// what this system has numbered, nor where faults are told apart.
  void remember_in(StepMemory& memory) { memory_ = &memory; }

  void initial(const Visit& visit) override;
  void successors(const SymbolicState& state, const Visit& visit) override;
  [[nodiscard]] bool accepts(const SymbolicState& state) const override;
  [[nodiscard]] bool no_more_faults(unsigned a, unsigned b) const override;
  [[nodiscard]] unsigned fault_count(unsigned faults) const override;
  [[nodiscard]] FaultMeasures fault_measures(unsigned faults) const override;
  /// From now on, which faults there were counts, by numbers of `sets`, to which a reference is kept.
  void tell_faults_apart(FaultSets& sets) { sets_ = &sets; }

  /// A discrete part, taken apart.
  static LoopStateId loop_state(std::uint64_t discrete) {
    return LoopStateId(static_cast<std::uint32_t>(discrete >> phase_bits));
  }
  /// Of `missed`: whether what is owed here has been asked for.
  static bool owed(std::uint64_t discrete) { return (discrete & owed_bit) != 0; }
  /// Whether time passed before the step that led here.
  static bool progressed(std::uint64_t discrete) { return (discrete & progressed_bit) != 0; }

  /// Whether what is to come has been asked for there, and has not come.
  [[nodiscard]] bool is_due(std::uint64_t discrete) const {
    return query_.aim == Query::Aim::late || (query_.aim == Query::Aim::missed && owed(discrete));
  }
  /// Whether a fault that runs are looked at after has happened.
  static bool happened(std::uint64_t discrete) { return (discrete & happened_bit) != 0; }
  /// Whether a run is cut off there, as nothing can follow or as time stands still.
  static bool is_end(std::uint64_t discrete) { return (discrete & (stuck_bit | still_bit)) != 0; }
  /// Where runs are cut off in states that have been seen by a search.
  [[nodiscard]] const CutOff& cut_off() const { return cut_off_; }
  /// In a state of that kind: how. Its zone is uniform, so that there is one answer.
  [[nodiscard]] Standstill standstill(const SymbolicState& end);
  /// What the clocks read there, as the cycle begins in the state before it, at the position of its path.
  [[nodiscard]] PathEnd end_of(const SymbolicState& end, std::size_t position) const;
  /// The state that a step of a round leads to.
  [[nodiscard]] static PathState state_after(const Instant& step);
  /// The accepted state that was found.
  [[nodiscard]] const SymbolicState& accepted() const { return *accepted_; }

  /// `Label::wait` of a state that has not waited; else it is a position in `Turn::waits`.
  static constexpr std::uint32_t no_wait = UINT32_MAX;
  /// `Label::move` of a state to start in; else it is a position in `Turn::outcomes`.
  static constexpr std::uint32_t no_move = UINT32_MAX;

 private:
  // A discrete part: what was achieved, where that is asked; the number of the state; the phase.
  static constexpr unsigned phase_bits = 6;
  static constexpr unsigned achieved_shift = phase_bits + 32;
  static constexpr std::uint64_t happened_bit = 1;
  static constexpr std::uint64_t progressed_bit = 2;
  static constexpr std::uint64_t stuck_bit = 4;
  static constexpr std::uint64_t still_bit = 8;
  static constexpr std::uint64_t undone_bit = 16;
  static constexpr std::uint64_t owed_bit = 32;

  /// Where a step comes from and what is true of it.
  struct Arrival {
    std::optional<LoopStateId> from;  ///< set where nothing changed: only other cells are new
    unsigned faults = 0;
    std::uint64_t phase = 0;
    Label label;
  };

  /// Whether something is to come.
  [[nodiscard]] bool awaits() const { return query_.aim == Query::Aim::late || query_.aim == Query::Aim::missed; }
  [[nodiscard]] bool stopwatch() const { return (awaits() && query_.deadline != unbounded) || query_.window; }
  /// Readings of the stopwatch at which what is due cannot come in time any more but now.
  [[nodiscard]] Interval last_chance() const { return {query_.deadline - loop_.time().grain(), unbounded}; }
  /// Of a state that nothing can follow: whether what is due could come in time only now.
  [[nodiscard]] bool is_last_chance(const SymbolicState& end) const {
    if (!is_due(end.discrete) || (end.discrete & stuck_bit) == 0) return false;
    return !stopwatch() || end.zone.lower(1) >= last_chance().lower;
  }
  [[nodiscard]] bool progress_clock() const { return query_.progress && loop_.time().is_dense(); }
  [[nodiscard]] std::size_t extra() const { return (stopwatch() ? 1u : 0u) + (progress_clock() ? 1u : 0u); }
  /// Notes what the step achieves and what it takes away.
  void note_achieved(const SymbolicState& state, const Turn& turn, const Outcome& outcome, Arrival& arrival);
  [[nodiscard]] std::uint64_t number(const Achieved& achieved);
  [[nodiscard]] bool is_filtered(const LoopState& from, const Outcome& outcome) const;
  void through(StepMemory::Move* known, base::FunctionRef<void(const Visit&)> work_out, const Visit& visit);
  [[nodiscard]] bool is_allowed(const SymbolicState& state, const Outcome& outcome) const;
  void step(const SymbolicState& state, const Turn& turn, std::uint32_t move, const Visit& visit);
  /// Enters a state in every choice of cells; the zone is over the clocks of `state` as it stands.
  void choose_cells(const LoopState& state, std::vector<Cell>& chosen, const Zone& zone, const Arrival& arrival,
                    const Visit& visit);
  void enter(LoopStateId id, const Zone& zone, const Arrival& arrival, const Visit& visit);
  void stay(LoopStateId id, Zone now, const Arrival& arrival, const Visit& visit);
  [[nodiscard]] bool wait(Zone& zone, const Wait& wait, LoopStateId id) const;
  [[nodiscard]] std::size_t clock_of(automata::ComponentId component, const LoopState& state) const;
  [[nodiscard]] std::vector<ClockLimits> limits_in(const LoopState& state, bool due) const;
  [[nodiscard]] std::optional<Standstill> stop_in(const Zone& zone, std::uint64_t discrete);
  void enter_end(const SymbolicState& state, const Visit& visit);
  [[nodiscard]] bool is_wanted(const SymbolicState& state) const;
  [[nodiscard]] bool is_spent(const SymbolicState& state) const;
  [[nodiscard]] unsigned faults_after(const SymbolicState& state, const Outcome& outcome) const;
  [[nodiscard]] bool is_fresh(LoopStateId id) const;
  [[nodiscard]] bool may_wait_for_ever(const SymbolicState& state) const;

  Loop& loop_;
  const std::vector<LoopState>& start_;
  const Query& query_;
  std::map<Achieved, std::uint64_t> achieved_numbers_{{{}, 0}};
  std::vector<const Achieved*> achieved_{&achieved_numbers_.begin()->first};  ///< by number
  FaultSets* sets_ = nullptr;                                                 ///< none: faults are counted
  StepMemory* memory_ = nullptr;                                              ///< none: all is worked out
  mutable CutOff cut_off_;
  mutable std::optional<SymbolicState> accepted_;
};

}  // namespace rmpl::verifier
