// Replaying a trace on the step function of semantics 3.
// SPDX-License-Identifier: MIT
#include "verifier/witness/replay.hpp"

#include <algorithm>
#include <set>

#include "verifier/witness/rules.hpp"
#include "verifier/witness/start.hpp"

namespace rmpl::verifier {

using automata::ControlAction;
using automata::Modes;
using automata::SystemState;
using automata::Ticks;
using automata::Transition;

namespace {

std::string at(Ticks time) { return " at " + automata::format_seconds(time) + " s"; }

class Replay {
 public:
  Replay(automata::PlantStep& step, const Witness& witness, const ReplayRules& rules)
      : step_(step), witness_(witness), rules_(rules), idle_(automata::idle_action(step.plant())) {}

  std::optional<std::string> run() {
    if (witness_.events.empty()) return "it has no start";
    if (auto failure = start()) return failure;
    for (std::size_t e = 1; e < witness_.events.size(); ++e) {
      if (auto failure = event(witness_.events[e - 1].time, witness_.events[e])) return failure;
    }
    if (faults_in(plant(), witness_) > rules_.faults) return "it has more faults than the budget";
    return std::nullopt;
  }

 private:
  [[nodiscard]] const automata::Plant& plant() const { return step_.plant(); }

  std::optional<std::string> start() {
    const Modes& modes = witness_.events.front().modes;
    if (auto failure = wrong_start(step_, modes, rules_.from)) return failure;
    if (witness_.events.front().time != Ticks{0}) return "it does not start at time 0";
    state_ = {modes, std::vector<Ticks>(modes.size(), Ticks{0})};
    return std::nullopt;
  }

  std::optional<std::string> event(Ticks before, const Event& event) {
    if (event.time < before) return "time runs backwards" + at(event.time);
    if (!is_free(plant(), rules_.commands, event.action)) return "the command is not free" + at(event.time);
    if (!step_.possible(event.modes)) return "the state is impossible" + at(event.time);
    auto failure = rules_.period ? sampled(before, event) : dense(before, event);
    state_ = automata::PlantStep::advance(state_, event.modes, event.time);
    return failure;
  }

  std::optional<std::string> dense(Ticks before, const Event& event) {
    if (event.time > before &&
        !every_component(idle_, event.time, event.time, [this](const Rules& rules, automata::ComponentId component) {
          return rules.allows_time(state_.modes[component.index()]);
        })) {
      return "time may not pass up to" + at(event.time);
    }
    const bool waits_only = event.modes == state_.modes && event.action == idle_;
    if (!waits_only && !possible(event.action, event.time, event.time, event.modes)) {
      return "the step is not possible" + at(event.time);
    }
    return std::nullopt;
  }

  std::optional<std::string> sampled(Ticks before, const Event& event) {
    const Ticks period = *rules_.period;
    const Ticks last = event.time - period;
    if (last < before || event.time.count % period.count != 0) return "it is not on the period" + at(event.time);
    for (const Ticks end : telling_periods(before, last)) {
      if (!positive(idle_, end - period, end, state_.modes)) return "nothing changing is not possible" + at(end);
    }
    if (!positive(event.action, last, event.time, event.modes)) return "the step is not possible" + at(event.time);
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
    for (std::size_t c = 0; c < state_.modes.size(); ++c) {
      for (const Transition& t : plant().components[c].transitions) {
        if (t.from != state_.modes[c] || !t.timing) continue;
        for (const Ticks bound : {t.timing->lower, t.timing->upper}) {
          if (bound > last) continue;
          const Ticks met = state_.clock_starts[c] + bound;
          const Ticks end{met.count / period.count * period.count};
          for (const Ticks near : {end - period, end, end + period}) look(near);
        }
      }
    }
    return ends;
  }

  template <class Test>
  bool every_component(const ControlAction& action, Ticks before, Ticks now, const Test& test) {
    const auto& enabled = step_.enabled(state_.modes, action);
    for (std::size_t c = 0; c < enabled.size(); ++c) {
      const Ticks start = state_.clock_starts[c];
      const Rules rules(plant().components[c], enabled[c], before - start, now - start, rules_.period);
      if (!test(rules, automata::ComponentId(c))) return false;
    }
    return true;
  }

  bool possible(const ControlAction& action, Ticks before, Ticks now, const Modes& next) {
    return every_component(action, before, now, [&](const Rules& rules, automata::ComponentId component) {
      return rules.allows(state_.modes[component.index()], next[component.index()]);
    });
  }

  bool positive(const ControlAction& action, Ticks before, Ticks now, const Modes& next) {
    return possible(action, before, now, next) && step_.leads(state_, action, before, now, next);
  }

  automata::PlantStep& step_;
  const Witness& witness_;
  const ReplayRules& rules_;
  ControlAction idle_;
  SystemState state_;
};

}  // namespace

std::optional<std::string> replay(automata::PlantStep& step, const Witness& witness, const ReplayRules& rules) {
  return Replay(step, witness, rules).run();
}

}  // namespace rmpl::verifier
