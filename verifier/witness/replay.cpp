// Replaying a run on the rules of semantics 3.
// SPDX-License-Identifier: MIT
#include "verifier/witness/replay.hpp"

#include <algorithm>
#include <set>

#include "verifier/witness/plant_run.hpp"

namespace rmpl::verifier {

using automata::Modes;
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
      if (witness_.repeats_from == e) begun_ = plant_.state();
      if (auto failure = event(witness_.events[e - 1].time, witness_.events[e])) return failure;
    }
    if (faults_in(plant_.plant(), witness_) > rules_.faults) return "it has more faults than the budget";
    return witness_.repeats_from && !witness_.stop ? goes_round() : std::nullopt;
  }

 private:
  std::optional<std::string> event(Ticks before, const Event& event) {
    if (event.time < before) return "time runs backwards" + at(event.time);
    if (!is_free(plant_.plant(), rules_.commands, event.action)) return "the command is not free" + at(event.time);
    if (!plant_.rules().possible(event.modes)) return "the state is impossible" + at(event.time);
    auto failure = rules_.period ? sampled(before, event) : dense(before, event);
    if (!failure && plant_.tells_too_much(event)) failure = "no such clock starts anew" + at(event.time);
    plant_.advance(event.action, event.modes, event.time);
    return failure;
  }

  /// Why the last part of the run cannot go on for ever. Where those that move in it have come back to the same
  /// readings, it is gone through once more, the others having been in their modes for longer than any bound counts.
  std::optional<std::string> goes_round() {
    const std::vector<Event>& events = witness_.events;
    const std::size_t first = *witness_.repeats_from;
    const Ticks round = events.back().time - events[first - 1].time;
    if (events[first - 1].modes != events.back().modes) return "it does not come back to where it repeats";
    if (round <= Ticks{0}) return "it goes round in no time" + at(events.back().time);
    Ticks longest{0};
    for (const automata::Component& component : plant_.plant().components) {
      for (const automata::Transition& t : component.transitions) {
        if (!t.timing) continue;
        longest = std::max(longest, t.timing->lower);
        if (!t.timing->upper.is_infinite()) longest = std::max(longest, t.timing->upper);
      }
    }
    plant_.age(begun_, events, first, longest + longest + round);
    for (std::size_t c = 0; c < begun_.modes.size(); ++c) {
      const bool same = plant_.state().clock_starts[c] == begun_.clock_starts[c] + round;
      const bool moves = plant_.state().clock_starts[c] > begun_.clock_starts[c];
      if (moves && !same) return std::nullopt;
    }
    for (std::size_t e = first; e < events.size(); ++e) {
      Event again = events[e];
      again.time = again.time + round;
      if (auto failure = event(events[e - 1].time + round, again)) return failure;
    }
    return std::nullopt;
  }

  std::optional<std::string> dense(Ticks before, const Event& event) {
    if (event.time > before) {
      if (!plant_.may_wait(idle_, before, event.time)) return "time may not pass up to" + at(event.time);
      plant_.advance(idle_, plant_.state().modes, event.time);
    }
    const bool waits_only =
        event.modes == plant_.state().modes && event.action == idle_ && (event.time > before || !restarts(idle_));
    if (!waits_only && !plant_.may_step(event.action, event.time, event.time, event.modes)) {
      return "the step is not possible" + at(event.time);
    }
    return std::nullopt;
  }

  std::optional<std::string> sampled(Ticks before, const Event& event) {
    const Ticks period = *rules_.period;
    const Ticks last = event.time - period;
    if (last < before || event.time.count % period.count != 0) return "it is not on the period" + at(event.time);
    const Modes here = plant_.state().modes;
    for (const Ticks end : telling_periods(before, last)) {
      if (end - period > before) plant_.advance(idle_, here, end - period);
      if (!plant_.may_step(idle_, end - period, end, here)) {
        return "nothing changing is not possible" + at(end);
      }
    }
    if (last > before) plant_.advance(idle_, here, last);
    if (!plant_.may_step(event.action, last, event.time, event.modes)) {
      return "the step is not possible" + at(event.time);
    }
    return std::nullopt;
  }

  [[nodiscard]] bool restarts(const automata::ControlAction& action) {
    const std::vector<bool> all = plant_.restarted(action);
    return std::find(all.begin(), all.end(), true) != all.end();
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
  automata::SystemState begun_;  ///< where the part begins that repeats
  const Witness& witness_;
  const ReplayRules& rules_;
  automata::ControlAction idle_;
};

}  // namespace

std::optional<std::string> replay(automata::PlainStep& rules, const Witness& witness, const ReplayRules& replay_rules) {
  return Replay(rules, witness, replay_rules).run();
}

}  // namespace rmpl::verifier
