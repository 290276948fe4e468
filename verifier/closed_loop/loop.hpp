// The closed loop of a program, a plant and the reconfigurer, one cycle at a time: its states, and what they lead to.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "automata/step/program_step.hpp"
#include "base/bounded_cache.hpp"
#include "runtime/reasoning/reconfigure/several_goals.hpp"
#include "verifier/behaviour/situation.hpp"
#include "verifier/closed_loop/clock_cells.hpp"
#include "verifier/search/lasso.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/witness/undone.hpp"

namespace rmpl::verifier {

/// Clocks that were started in one cycle, and so read the same for ever.
struct ClockGroup {
  std::vector<automata::ClockId> clocks;  ///< ascending, not empty
  std::uint32_t position = 0;             ///< the first one of the cell that they are in
  auto operator<=>(const ClockGroup&) const = default;
};

/// Where the loop is at the start of a cycle, but for clock readings. The estimate is the truth. Program clocks that
/// are not read any more are left out.
struct LoopState {
  automata::Marking marking;  ///< empty: the program has ended
  automata::Modes modes;
  std::vector<automata::ClockId> passed;    ///< in their last cell, ascending: how long they run cannot matter
  std::vector<ClockGroup> groups;           ///< the others, those that started earlier first
  std::vector<bool> no_plan = {};           ///< by `Loop::no_plan_asked`: what the cycle that led here has answered
  runtime::StrategyPosition position = {};  ///< what that cycle's answer has led to
  auto operator<=>(const LoopState&) const = default;
};

/// A position in `Loop`.
using LoopStateId = automata::Id<struct LoopStateTag>;

/// What one cycle leads to. The cells of the clocks there are those of before, as no time may have passed.
struct Outcome {
  LoopState state;
  std::vector<std::size_t> sources;  ///< per group of `state`: 1 + its position in the state before, or 0: starts now
  unsigned faults = 0;
  Box bounds;         ///< at the end of the cycle
  bool same = false;  ///< nothing changes, but for clocks that start anew
};

/// A stretch of cycles in which nothing changes.
struct Wait {
  Box bounds;
  /// In dense time, the groups of clocks that each round of its cycles starts anew: as time passes they stay at 0.
  std::vector<std::size_t> restarted;
  /// Likewise of the clocks passed. It matters to nothing that follows; only what they read is another.
  std::vector<automata::ClockId> restarted_passed;
  /// The components whose clocks restarts start anew in each round: they stay at 0, in sampled time as each cycle
  /// begins. `bounds` are then readings as the wait begins, and it lasts a unit at least.
  std::vector<automata::ComponentId> anew;
  bool endless = false;  ///< it may last for ever, and then nothing but a fault would ever end it; perhaps the program
                         ///< has ended
  /// Of an endless one: what clocks read from when on nothing but a fault would change anything. Until then a component
  /// may leave its mode yet, in steps that end before a bound by which it has to stay.
  Box settled;
};

/// The cycle that starts in a state. It is the same wherever the clocks are in their cells.
struct Turn {
  automata::Goals goals;  ///< that were acted on: empty where goals contradict each other
  std::vector<automata::GoalConflict> conflicts;
  runtime::Reconfiguration answer;
  std::vector<runtime::LeftOut> left_out;
  std::vector<bool> no_plan;  ///< of what it leads to, as `LoopState` has it
  automata::ControlAction action;
  std::vector<Outcome> outcomes;  ///< those with fewer faults first
  std::vector<Wait> waits;
  std::vector<automata::ComponentId> anew;  ///< whose clocks, of those that matter, restarts start anew in the cycle
  Exits exits;
  std::vector<ClockBound> faulty;  ///< where a fault of a component is certain, at the end of the cycle
};

/// Whether some goal of the cycle has no plan.
inline bool lacks_a_plan(const Turn& turn) {
  return turn.answer.outcome == runtime::Reconfiguration::Outcome::no_plan || !turn.left_out.empty();
}

/// All states of the loop met so far. Works cycles out on the step functions themselves.
class Loop {
 public:
  /// `program` is bound to the plant; `asked`: formulas of which `holds` will be asked. Keeps references.
  Loop(const automata::Program& program, automata::PlantStep& step, runtime::Reconfigurer& reconfigurer,
       const TimeModel& time, unsigned faults, Meter& meter, const std::vector<automata::Formula>& asked);

  [[nodiscard]] const automata::Plant& plant() const { return step_.plant(); }
  [[nodiscard]] const automata::Program& program() const { return program_; }
  [[nodiscard]] const TimeModel& time() const { return time_; }
  [[nodiscard]] const ClockCells& cells() const { return cells_; }
  /// How many may happen in all.
  [[nodiscard]] unsigned faults() const { return faults_; }
  void allow_faults(unsigned faults) { faults_ = faults; }

  /// The program at its start beside every possible initial state of the plant, or with the given modes.
  std::vector<LoopState> initial(const std::vector<automata::Assignment>& from);
  LoopStateId number(const LoopState& state);
  [[nodiscard]] const LoopState& operator[](LoopStateId id) const { return *states_[id.index()]; }
  /// Worked out when it is asked for, and kept until the state is explored; soon after that it is forgotten, and worked
  /// out again where it is asked for again: turns take far more memory than states.
  /// `faults` are those that may still happen in it; outcomes with more are left out at the end of the list.
  std::shared_ptr<const Turn> turn(LoopStateId id, unsigned faults = 0);
  /// The command of the cycle that starts there.
  automata::ControlAction action(LoopStateId id) { return cycle(id)->turn.action; }
  /// What that cycle leads to where the plant comes to these modes, which are possible: only `state` and `sources`.
  std::vector<Outcome> outcomes(LoopStateId id, const std::vector<automata::Modes>& modes);
  /// Whether under the command of the state each component lets time pass at some reading of its clock.
  bool may_rest(LoopStateId id);
  /// What follows the state has been seen.
  void explored(LoopStateId id);

  /// Whether a formula holds at a state: the store implies it, or (not `certain`) allows it. What it asks of the
  /// executive's knowledge is judged by the truth (known_truth.hpp).
  bool holds(const automata::Formula& formula, const LoopState& state, bool certain);

  [[nodiscard]] Cell cell(const ClockGroup& group) const { return cells_.around(group.clocks, group.position); }
  /// What a cycle takes away of what was achieved.
  Achieved taken_away(const Achieved& achieved, const CycleTaken& cycle) {
    return verifier::taken_away(step_, achieved, cycle);
  }
  /// The components whose clocks matter in these modes, ascending.
  [[nodiscard]] std::vector<automata::ComponentId> live(const automata::Modes& modes) const;

 private:
  struct Worked {
    Turn turn;
    unsigned faults = 0;  ///< of its outcomes, at most
    bool waits = false;   ///< they are known too
  };
  struct IdHash {
    std::size_t operator()(LoopStateId id) const noexcept { return id.index() * 0x9e3779b97f4a7c15u; }
  };

  /// The turn, perhaps without its waits.
  std::shared_ptr<Worked> cycle(LoopStateId id, unsigned faults = 0);
  [[nodiscard]] std::shared_ptr<Worked> known(LoopStateId id);
  [[nodiscard]] Turn work_out(const LoopState& state, unsigned faults);
  /// What the sequencer knows: the modes, and of itself what is so of the truth.
  [[nodiscard]] automata::Knowledge knowledge(const automata::Modes& modes, const std::vector<bool>& no_plan);
  [[nodiscard]] bool is_known(const automata::Formula& atom, const std::vector<automata::Assignment>& modes,
                              const std::vector<bool>& no_plan);
  [[nodiscard]] std::vector<std::optional<automata::Ticks>> started(const LoopState& state) const;
  /// What follows `state` where the plant is in `modes` and the sequencer has finished the cycle.
  [[nodiscard]] Outcome follow(const LoopState& state, const automata::Modes& modes, const Turn& turn) const;
  /// What cycles go round in while the plant stays as it is.
  struct Round {
    std::vector<LoopStateId> states;                  ///< none where they do not go round, or the plant cannot stay
    std::vector<std::size_t> restarted;               ///< of the first state, the groups of clocks that start anew
    std::vector<automata::ClockId> restarted_passed;  ///< likewise of the clocks passed
  };
  /// From a state on, which is the first. Sampled, only a cycle that changes nothing goes round: others are steps, one
  /// a period.
  Round round(LoopStateId id);
  std::vector<Wait> waits(LoopStateId id);
  Box settled_after(const std::vector<LoopStateId>& states, const std::vector<bool>& anew);
  [[nodiscard]] bool leaves_anew(const Turn& turn, const automata::Modes& modes, std::size_t component) const;
  /// In dense time: where a wait may begin, and where it ends at the latest, as a fault that is certain begins there.
  [[nodiscard]] std::vector<Interval> stays(const std::vector<Choice>& choices, automata::ModeId mode) const;
  [[nodiscard]] std::vector<Choice> choices_of(const LoopState& state, const Turn& turn,
                                               automata::ComponentId component);

  const automata::Program& program_;
  automata::PlantStep& step_;
  runtime::Reconfigurer& reconfigurer_;
  TimeModel time_;
  unsigned faults_;
  Meter& meter_;
  ClockCells cells_;
  automata::ProgramStep sequencer_;
  std::vector<automata::Formula> no_plan_asked_;  ///< `noplan`, `noplan(c)`, each once
  std::map<LoopState, LoopStateId> numbers_;
  std::vector<const LoopState*> states_;
  std::unordered_map<LoopStateId, std::shared_ptr<Worked>, IdHash> turns_;           ///< of states not yet explored
  base::BoundedCache<LoopStateId, std::shared_ptr<Worked>, IdHash> explored_turns_;  ///< the last of the others
};

}  // namespace rmpl::verifier
