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
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "verifier/closed_loop/clock_cells.hpp"
#include "verifier/plant/situation.hpp"
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
  std::vector<automata::ClockId> passed;  ///< in their last cell, ascending: how long they run cannot matter
  std::vector<ClockGroup> groups;         ///< the others, those that started earlier first
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
  bool same = false;  ///< nothing changes
};

/// A stretch of cycles in which nothing changes.
struct Wait {
  Box bounds;
  /// In dense time, the groups of clocks that each round of its cycles starts anew: as time passes they stay at 0.
  std::vector<std::size_t> restarted;
  bool endless = false;  ///< it may last for ever, and then nothing but a fault would ever end it
};

/// The ways out of modes that are enabled in a cycle however late it is, so that chance takes them at last where they
/// stay open: per component, the modes that they lead to, ascending.
struct Exits {
  std::vector<std::vector<automata::ModeId>> enabled;
  std::vector<std::vector<automata::ModeId>> open;  ///< those that some joint step takes to a possible state
  auto operator<=>(const Exits&) const = default;
};

/// The cycle that starts in a state. It is the same wherever the clocks are in their cells.
struct Turn {
  std::vector<automata::Assignment> goal;  ///< that was acted on: empty where goals contradict each other
  std::vector<automata::GoalConflict> conflicts;
  runtime::Reconfiguration answer;
  automata::ControlAction action;
  std::vector<Outcome> outcomes;  ///< those with fewer faults first
  std::vector<Wait> waits;
  Exits exits;
  std::vector<ClockBound> faulty;  ///< where a fault of a component is certain, at the end of the cycle
};

/// All states of the loop met so far. Works cycles out on the step functions themselves.
class Loop {
 public:
  /// `program` is bound to the plant. Keeps references to all but `reading`.
  Loop(const automata::Program& program, automata::PlantStep& step, runtime::Reconfigurer& reconfigurer,
       const TimeModel& time, unsigned faults, Meter& meter);

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
  /// What follows the state has been seen.
  void explored(LoopStateId id);

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
  /// Notes the exits that a joint step to a possible state takes.
  void open_exits(const automata::Modes& from, const automata::Modes& to, const Box& bounds, Exits& exits) const;
  [[nodiscard]] Turn work_out(const LoopState& state, unsigned faults);
  [[nodiscard]] std::vector<std::optional<automata::Ticks>> started(const LoopState& state) const;
  /// What follows `state` where the plant is in `modes` and the sequencer has finished the cycle.
  [[nodiscard]] Outcome follow(const LoopState& state, const automata::Modes& modes) const;
  /// What cycles go round in while the plant stays as it is.
  struct Round {
    std::vector<LoopStateId> states;     ///< none where they do not go round, or the plant cannot stay
    std::vector<std::size_t> restarted;  ///< of the first state, the groups of clocks that start anew
  };
  /// From a state on, which is the first. Sampled, only a cycle that changes nothing goes round: others are steps, one
  /// a period.
  Round round(LoopStateId id);
  std::vector<Wait> waits(LoopStateId id);
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
  std::map<LoopState, LoopStateId> numbers_;
  std::vector<const LoopState*> states_;
  std::unordered_map<LoopStateId, std::shared_ptr<Worked>, IdHash> turns_;           ///< of states not yet explored
  base::BoundedCache<LoopStateId, std::shared_ptr<Worked>, IdHash> explored_turns_;  ///< the last of the others
};

}  // namespace rmpl::verifier
