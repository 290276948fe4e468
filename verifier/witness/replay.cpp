// Replaying a run on the rules of semantics 3.
// SPDX-License-Identifier: MIT
#include "verifier/witness/replay.hpp"

#include <set>

#include "verifier/witness/plant_run.hpp"

namespace rmpl::verifier {

using automata::Ticks;

namespace {

class Replay {
 public:
  Replay(automata::PlainStep& rules, const Witness& witness, const ReplayRules& replay_rules)
      : plant_(rules, replay_rules.period),
        witness_(witness),
        rules_(replay_rules),
        idle_(automata::idle_action(rules.plant())) {}

  std::optional<std::string> run() {
    if (witness_.events.empty()) return "it has no start";
    if (auto failure = plant_.start(witness_.events.front().modes, rules_.from)) return failure;
    if (witness_.events.front().time != Ticks{0}) return "it does not start at time 0";
    for (std::size_t e = 1; e < witness_.events.size(); ++e) {
      if (auto failure = event(witness_.events[e - 1].time, witness_.events[e])) return failure;
    }
    if (faults_in(plant_.plant(), witness_) > rules_.faults) return "it has more faults than the budget";
    return std::nullopt;
  }

 private:
  std::optional<std::string> event(Ticks before, const Event& event) {
    if (event.time < before) return "time runs backwards" + at(event.time);
    if (!is_free(plant_.plant(), rules_.commands, event.action)) return "the command is not free" + at(event.time);
    if (!plant_.rules().possible(event.modes)) return "the state is impossible" + at(event.time);
    auto failure = rules_.period ? sampled(before, event) : dense(before, event);
    plant_.advance(event.modes, event.time);
    return failure;
  }

  std::optional<std::string> dense(Ticks before, const Event& event) {
    if (event.time > before && !plant_.may_wait(idle_, before, event.time))
      return "time may not pass up to" + at(event.time);
    const bool waits_only = event.modes == plant_.state().modes && event.action == idle_;
    if (!waits_only && !plant_.may_step(event.action, event.time, event.time, event.modes)) {
      return "the step is not possible" + at(event.time);
    }
    return std::nullopt;
  }

  std::optional<std::string> sampled(Ticks before, const Event& event) {
    const Ticks period = *rules_.period;
    const Ticks last = event.time - period;
    if (last < before || event.time.count % period.count != 0) return "it is not on the period" + at(event.time);
    for (const Ticks end : telling_periods(before, last)) {
      if (!plant_.may_step(idle_, end - period, end, plant_.state().modes)) {
        return "nothing changing is not possible" + at(end);
      }
    }
    if (!plant_.may_step(event.action, last, event.time, event.modes)) {
      return "the step is not possible" + at(event.time);
    }
    return std::nullopt;
  }

  /// The ends of those periods after `before` and up to `last` in which a clock is near a bound, the first and the
  /// last.
  [[nodiscard]] std::set<Ticks> telling_periods(Ticks before, Ticks last) const {
    const Ticks period = *rules_.period;
    std::set<Ticks> ends;
    const auto look = [&](Ticks end) {
      if (end > before && end <= last) ends.insert(end);
    };
    look(before + period);
    look(last);
    for (const Ticks met : plant_.meets_bounds(last)) {
      const Ticks end{met.count / period.count * period.count};
      for (const Ticks near : {end - period, end, end + period}) look(near);
    }
    return ends;
  }

  PlantRun plant_;
  const Witness& witness_;
  const ReplayRules& rules_;
  automata::ControlAction idle_;
};

}  // namespace

std::optional<std::string> replay(automata::PlainStep& rules, const Witness& witness, const ReplayRules& replay_rules) {
  return Replay(rules, witness, replay_rules).run();
}

}  // namespace rmpl::verifier
