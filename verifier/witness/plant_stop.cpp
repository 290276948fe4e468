// How the run of a plant ends: in a deadlock, a timelock or a certain fault.
// SPDX-License-Identifier: MIT
#include "verifier/witness/plant_stop.hpp"

#include <map>
#include <tuple>

#include "verifier/witness/plant_run.hpp"
#include "verifier/witness/steps_at.hpp"

namespace rmpl::verifier {

using automata::ControlAction;
using automata::Modes;
using automata::PlainStep;
using automata::SystemState;
using automata::Ticks;

namespace {

struct ByParts {
  bool operator()(const SystemState& a, const SystemState& b) const {
    return std::tie(a.modes, a.clock_starts) < std::tie(b.modes, b.clock_starts);
  }
};

class Stops {
 public:
  Stops(PlainStep& rules, Witness& witness, Commands commands, std::optional<Ticks> period)
      : rules_(rules),
        witness_(witness),
        commands_(commands),
        period_(period),
        now_(witness.events.back().time),
        idle_(automata::idle_action(rules.plant())) {}

  std::optional<std::string> explain() {
    const SystemState end = end_of_run();
    if (!step_from(end)) return blame(end);
    if (period_) return "a step is possible";
    for (SystemState state = end; !met_.contains(state); first_ = false) {
      if (fault_is_certain(state)) return "a fault is certain";
      if (StepsAt(rules_, state, now_, std::nullopt).time_passes(idle_)) return "time can pass";
      const auto next = step_from(state);
      if (!next) break;
      met_.emplace(state, witness_.events.size());
      witness_.events.push_back(*next);
      state = rules_.advance(state, next->action, next->modes, now_);
      if (const auto before = met_.find(state); before != met_.end()) witness_.repeats_from = before->second;
    }
    witness_.stop.emplace().still = true;
    return std::nullopt;
  }

 private:
  [[nodiscard]] SystemState end_of_run() {
    return state_at(rules_, witness_.events, witness_.events.size() - 1, period_);
  }

  bool fault_is_certain(const SystemState& state) {
    return StepsAt(rules_, state, now_ + period_.value_or(Ticks{0}), period_).fault_is_certain(idle_);
  }

  /// Some step out of the state under a free command, the simplest command first.
  std::optional<Event> step_from(const SystemState& state) {
    std::optional<Event> result;
    const Ticks at = now_ + period_.value_or(Ticks{0});
    for_each_action(rules_.plant(), commands_, [&](const ControlAction& action) {
      if (result) return;
      StepsAt(rules_, state, at, period_, first_ ? &idle_ : nullptr).any(action, [&](const Modes& modes) {
        result = Event{at, modes, action};
        return true;
      });
    });
    return result;
  }

  std::optional<std::string> blame(const SystemState& state) {
    if (fault_is_certain(state)) return "a fault is certain";
    if (!period_ && StepsAt(rules_, state, now_, std::nullopt).time_passes(idle_)) return "time can pass";
    StepsAt steps(rules_, state, now_ + period_.value_or(Ticks{0}), period_, &idle_);
    steps.any(idle_, [](const Modes&) { return true; });
    witness_.stop.emplace().refused = steps.refused();
    if (!steps.refused().empty()) witness_.stop->conflict = conflict_of(rules_.plant(), steps.refused());
    return std::nullopt;
  }

  PlainStep& rules_;
  Witness& witness_;
  Commands commands_;
  std::optional<Ticks> period_;
  Ticks now_;
  ControlAction idle_;
  bool first_ = true;                                ///< nothing has been taken after the end of the run
  std::map<SystemState, std::size_t, ByParts> met_;  ///< with the event that leads out of each
};

}  // namespace

std::optional<std::string> explain_stop(PlainStep& rules, Witness& witness, Commands commands,
                                        std::optional<Ticks> period) {
  return Stops(rules, witness, commands, period).explain();
}

}  // namespace rmpl::verifier
