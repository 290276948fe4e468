// Behaviours: what each component may do next, looked up by the little that it depends on.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "automata/store/memory.hpp"
#include "verifier/behaviour/choices.hpp"
#include "verifier/behaviour/decisions.hpp"
#include "verifier/behaviour/like_modes.hpp"

namespace rmpl::verifier {

class Folds;

/// What one component may do in one step, and how long it lets time pass. Numbered: equal numbers, equal behaviour.
struct Behaviour {
  std::vector<Choice> choices;        ///< see `choices` in choices.hpp
  std::vector<Interval> waits;        ///< see `waits` there
  bool changes = false;               ///< some choice is another mode
  bool restarts = false;              ///< its clock, which matters, starts anew with each step
  std::vector<Interval> faulty = {};  ///< see `without_nominal` there
  Units stays_until = -1;             ///< it may stay while its clock reads at most this; below 0: not from the start
  [[nodiscard]] bool free_to_stay() const { return stays_until == unbounded; }
};

/// A position in `Behaviours`.
using BehaviourId = automata::Id<struct BehaviourTag>;

/// The behaviours of a plant in one reading of time. Keeps references to all but the reading.
///
/// What decides a guard is mostly far less than what could: a command that is not given refutes it whatever the rest of
/// the plant does. Each answer is therefore remembered under its reason, the failed assumptions of its proof (which
/// propagation finds, and mostly none could be spared); only where a guard is neither implied nor refuted is it
/// remembered under all that could matter. Modes of others that are alike are one in all of this.
class Behaviours {
 public:
  Behaviours(automata::PlantStep& step, const TimeModel& time);

  /// From here on timers that are folded in the modes at hand stay in theirs. Keeps a reference. Before anything is
  /// read.
  void fold(Folds& folds) { folds_ = &folds; }
  [[nodiscard]] const Behaviour& operator[](BehaviourId id) const { return table_[id.index()]; }
  /// Whether any behaviour met so far restarts.
  [[nodiscard]] bool some_restart() const { return some_restart_; }
  /// Per component, in possible modes under a control action; whether the store is consistent with it there.
  bool read(const automata::Modes& modes, const automata::ControlAction& action, std::vector<BehaviourId>& result);
  /// What has been read somewhere else. Keeps references.
  struct Known {
    const automata::Modes& modes;
    const automata::ControlAction& action;  ///< the store is consistent with it there
    const std::vector<BehaviourId>& behaviours;
  };
  /// The same, by looking up only what reads something that is different there.
  void read(const Known& elsewhere, const automata::Modes& modes, const automata::ControlAction& action,
            std::vector<BehaviourId>& result);
  [[nodiscard]] automata::PlantStep& step() { return step_; }
  [[nodiscard]] const TimeModel& time() const { return time_; }

 private:
  struct Answers {
    Decisions decided;
    automata::Memory<BehaviourId> rest;
  };

  BehaviourId number(automata::ModeId mode, std::vector<Choice> all, std::vector<Interval> pauses, bool restarts);
  BehaviourId number(automata::ComponentId component, automata::ModeId mode, const automata::Enabled& enabled);
  BehaviourId look_up(automata::ComponentId component, automata::ModeId mode, const automata::ControlAction& action);
  /// Those of timers that are folded in the modes take the places of their own.
  void fold(const automata::Modes& modes, std::vector<BehaviourId>& result);
  BehaviourId folded(automata::ModeId mode, BehaviourId id);

  automata::PlantStep& step_;
  TimeModel time_;
  LikeModes like_;
  automata::Modes seen_;  ///< the modes at hand, as the store tells them apart
  std::deque<Behaviour> table_;
  bool some_restart_ = false;
  std::map<std::tuple<automata::ModeId, std::vector<Choice>, std::vector<Interval>, bool>, BehaviourId> numbers_;
  std::vector<std::vector<Answers>> known_;  ///< per component, per mode
  /// Per component, then per control: the components whose guards, in some mode, could depend on it.
  std::vector<std::vector<automata::ComponentId>> readers_;
  Folds* folds_ = nullptr;                               ///< none: timers are modes
  std::unordered_map<BehaviourId, BehaviourId> folded_;  ///< looked up, never iterated
};

}  // namespace rmpl::verifier
