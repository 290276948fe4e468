// Situations: a mode for every component, with all that may happen there.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "verifier/behaviour/exits.hpp"
#include "verifier/behaviour/joint_steps.hpp"
#include "verifier/behaviour/modes_table.hpp"

namespace rmpl::verifier {

/// A position in `Situations`.
using SituationId = automata::Id<struct SituationTag>;

/// One joint step of all components, or, in sampled time, a hold: periods in which a command keeps everything from
/// changing although it would under idle controls.
struct JointStep {
  SituationId target;
  std::uint32_t action;  ///< position in `Situations::action`; the first one that enables it
  unsigned faults = 0;
  bool hold = false;  ///< `bounds` is then like a wait's
  Box bounds;
  std::vector<automata::ComponentId> restarted = {};  ///< whose clocks restarts start anew in it; ascending
  std::uint32_t exits = 0;                            ///< a position in `Situations::exits`, where exits are told
};

/// What may happen in given modes. The clocks that matter are those of components whose mode has a timed exit.
struct Situation {
  automata::Modes modes;
  std::vector<automata::ComponentId> live;  ///< ascending
  std::vector<Box> waits;                   ///< see `waits` in choices.hpp; within one of these boxes time may pass
  std::vector<automata::ComponentId> restarted;  ///< with idle controls, as of `JointStep`: in each cycle of a wait
  std::vector<Units> stays_until;                ///< of the live ones: see `Behaviour`, with idle controls
  std::vector<ClockBound> faulty;                ///< where a fault of a component is certain, with idle controls
  std::vector<ClockLimits> limits;               ///< of the live ones: the greatest constants that their clocks meet
};

/// All situations met so far, by number, in the order in which they were met; what may happen in them is remembered for
/// some, and worked out again for others. One table serves several searches.
class Situations {
 public:
  /// Keeps references to the step function and the meter, which is polled while moves are worked out; it may throw.
  Situations(automata::PlantStep& step, const TimeModel& time, Commands commands, unsigned faults, Meter& meter);

  [[nodiscard]] automata::PlantStep& step() { return step_; }
  [[nodiscard]] const automata::Plant& plant() const { return step_.plant(); }
  [[nodiscard]] unsigned faults() const { return faults_; }
  [[nodiscard]] const TimeModel& time() const { return behaviours_.time(); }
  [[nodiscard]] const automata::ControlAction& action(std::uint32_t position) const { return actions_[position]; }
  /// Whether the step takes no command.
  [[nodiscard]] static bool is_idle(const JointStep& step) { return step.action == 0; }
  /// While it lives, only the irreducible joint steps are moves (JointSteps); else all are.
  class [[nodiscard]] FewerSteps {
   public:
    FewerSteps(Situations& situations, const std::vector<automata::ComponentId>& visible) : situations_(situations) {
      situations_.use(Steps::irreducible, visible);
    }
    ~FewerSteps() { situations_.use(Steps::all, {}); }
    FewerSteps(const FewerSteps&) = delete;
    FewerSteps& operator=(const FewerSteps&) = delete;

   private:
    Situations& situations_;
  };
  /// From here on timers are folded: those that are in their modes stay there whatever their clocks read. Keeps a
  /// reference. Before anything is asked.
  void fold(Folds& folds);
  /// From here on moves are told up to the symmetry (JointSteps::up_to). Keeps a reference.
  void up_to(const Symmetry& symmetry);

  /// From here on steps are told apart by what else is enabled in them, and never left out for what another command
  /// leads to. For runs without end.
  void tell_exits() {
    tells_exits_ = true;
    use(Steps::all, {});
  }
  /// What is enabled under the command of a step; where exits are told.
  [[nodiscard]] const Exits& exits(std::uint32_t position) const { return *exits_[position]; }
  /// What is enabled while time passes with all controls idle.
  const Exits& idle_exits(SituationId id);

  /// The number of possible modes.
  SituationId number(const automata::Modes& modes) { return SituationId(table_.intern(modes)); }
  [[nodiscard]] automata::Modes modes(SituationId id) const;
  [[nodiscard]] std::shared_ptr<const Situation> operator[](SituationId id);
  /// Every joint step that changes a mode, or starts a clock anew, with no more faults than these; holds first. Always
  /// in the same order. `late` matters only where steps are left out; those that are `due` stay no longer
  /// (JointSteps::set_out).
  std::shared_ptr<const std::vector<JointStep>> moves(SituationId id, const Late& late, unsigned faults,
                                                      const Late& due = {});

  /// Whether, with idle controls, the first of the components, which are at the bounds up to which they stay, can leave
  /// its mode, beside any of the others that leave theirs. In dense time; for few components, else no.
  [[nodiscard]] bool leave_together(const automata::Modes& modes, const Late& due, std::size_t first);

  /// The possible modes of the initial distribution, or with the given modes in its place for their components.
  std::vector<automata::Modes> initial(const std::vector<automata::Assignment>& from);

 private:
  void use(Steps steps, const std::vector<automata::ComponentId>& visible);
  std::uint32_t position_of(const automata::ControlAction& action);
  [[nodiscard]] Situation describe(const automata::Modes& modes);
  [[nodiscard]] std::vector<Box> waits(const std::vector<BehaviourId>& behaviours) const;
  [[nodiscard]] std::vector<automata::ComponentId> restarted(const std::vector<BehaviourId>& behaviours) const;
  std::uint32_t exits_in(const automata::Modes& modes, const std::vector<BehaviourId>& behaviours);
  [[nodiscard]] std::vector<JointStep> work_out(const automata::Modes& modes, const Late& late, unsigned faults,
                                                const Late& due);

  automata::PlantStep& step_;
  Behaviours behaviours_;
  Commands commands_;
  unsigned faults_;
  Meter& meter_;
  ModesTable table_;
  JointSteps joint_steps_;
  std::vector<std::vector<std::optional<ClockLimits>>> limits_;  ///< per component, per mode: of its clock, if live
  std::vector<automata::ControlAction> actions_;                 ///< those of moves, in the order in which they came up
  std::map<automata::ControlAction, std::uint32_t> action_positions_;
  bool tells_exits_ = false;
  std::map<Exits, std::uint32_t> exits_positions_;
  std::vector<const Exits*> exits_;
  std::map<SituationId, std::uint32_t> idle_exits_;
  // Of the moves at hand; their memory serves the next:
  std::vector<BehaviourId> behaviours_here_, idling_;
  std::vector<BehaviourId> rows_;          ///< what all may do, by action
  std::vector<std::size_t> seen_rows_;     ///< where they begin, in order
  std::vector<std::uint32_t> seen_steps_;  ///< positions in the result, in order
  base::BoundedCache<std::uint32_t, std::shared_ptr<const Situation>, std::hash<std::uint32_t>> described_;
  std::map<std::tuple<SituationId, Late, unsigned, Late>, std::shared_ptr<const std::vector<JointStep>>>
      moves_;  ///< a few of the last
};

}  // namespace rmpl::verifier
