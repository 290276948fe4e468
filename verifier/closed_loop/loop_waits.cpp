// How long time may pass in a state of the closed loop, and the rounds of cycles in which nothing but the marking
// changes. SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <numeric>

#include "verifier/closed_loop/loop.hpp"

namespace rmpl::verifier {

using automata::ClockId;
using automata::ComponentId;
using automata::ModeId;
using automata::Modes;

Loop::Round Loop::round(LoopStateId id) {
  Round result;
  // For each group of the state at hand 1 + the position at the begin of the one that it is, or 0: it started since.
  std::vector<std::size_t> sources(states_[id.index()]->groups.size());
  std::iota(sources.begin(), sources.end(), std::size_t{1});
  for (LoopStateId at = id;;) {
    result.states.push_back(at);
    const LoopState& state = *states_[at.index()];
    const std::shared_ptr<const Worked> worked = cycle(at);
    const Turn& turn = worked->turn;
    const auto stays = std::find_if(turn.outcomes.begin(), turn.outcomes.end(),
                                    [&](const Outcome& o) { return o.faults == 0 && o.state.modes == state.modes; });
    if (stays == turn.outcomes.end() || (!stays->same && !time_.is_dense())) return {};
    std::vector<std::size_t> moved;
    for (const std::size_t source : stays->sources) moved.push_back(source == 0 ? 0 : sources[source - 1]);
    sources = std::move(moved);
    at = number(stays->state);
    if (at == id) break;
    if (std::find(result.states.begin(), result.states.end(), at) != result.states.end()) return {};
  }
  // One that has taken the place of another is started anew too, a round later.
  for (std::size_t g = 0; g < sources.size(); ++g) {
    if (sources[g] != g + 1) result.restarted.push_back(g);
  }
  // A clock stays passed for as long as it runs.
  for (const ClockId clock : states_[id.index()]->passed) {
    const bool runs_on = std::all_of(result.states.begin(), result.states.end(), [&](LoopStateId state) {
      const std::vector<ClockId>& passed = states_[state.index()]->passed;
      return std::binary_search(passed.begin(), passed.end(), clock);
    });
    if (!runs_on) result.restarted_passed.push_back(clock);
  }
  return result;
}

std::vector<Interval> Loop::stays(const std::vector<Choice>& choices, ModeId mode) const {
  if (!time_.is_dense()) return {Interval{}};
  std::vector<Interval> result;
  for (const Choice& choice : choices) {
    if (choice.faults == 0 && choice.mode == mode) result.push_back(choice.clock);
  }
  result = merged(std::move(result));
  for (Interval& stay : result) {
    if (stay.upper != unbounded) ++stay.upper;
  }
  return result;
}

/// When components can leave their modes no more that could up to some reading, in any cycle of a round.
Box Loop::settled_after(const std::vector<LoopStateId>& states, const std::vector<bool>& anew) {
  const Modes modes = states_[states.front().index()]->modes;
  std::map<ComponentId, Units> last;
  for (const LoopStateId at : states) {
    const std::shared_ptr<const Worked> worked = cycle(at);
    for (const Outcome& outcome : worked->turn.outcomes) {
      if (outcome.faults > 0) continue;
      for (const ClockBound& bound : outcome.bounds) {
        const std::size_t c = bound.component.index();
        if (outcome.state.modes[c] == modes[c] || bound.clock.upper == unbounded || anew[c]) continue;
        Units& known = last[bound.component];
        known = std::max(known, bound.clock.upper);
      }
    }
  }
  Box result;
  for (const auto& [component, upper] : last) result.push_back({component, {upper, unbounded}});
  return result;
}

/// Whether the component may leave its mode in the cycle, with its clock started anew just before.
bool Loop::leaves_anew(const Turn& turn, const Modes& modes, std::size_t component) const {
  const Units reading = time_.is_dense() ? 0 : 1;
  return std::any_of(turn.outcomes.begin(), turn.outcomes.end(), [&](const Outcome& outcome) {
    return outcome.faults == 0 && outcome.state.modes[component] != modes[component] &&
           std::none_of(outcome.bounds.begin(), outcome.bounds.end(), [&](const ClockBound& b) {
             return b.component == ComponentId(component) && !b.clock.contains(reading);
           });
  });
}

std::vector<Wait> Loop::waits(LoopStateId id) {
  const auto [states, restarted, restarted_passed] = round(id);
  if (states.empty()) return {};
  const LoopState& state = *states_[id.index()];
  std::vector<Wait> result(1);
  result.front().restarted = restarted;
  result.front().restarted_passed = restarted_passed;
  std::vector<bool> anew(state.modes.size(), false);
  for (const LoopStateId at : states) {
    const std::shared_ptr<const Worked> worked = cycle(at);
    for (const ComponentId c : worked->turn.anew) anew[c.index()] = true;
  }
  for (std::size_t c = 0; c < anew.size(); ++c) {
    if (anew[c]) result.front().anew.emplace_back(c);
  }
  bool restless = restarted.size() < state.groups.size();
  for (std::size_t c = 0; c < state.modes.size(); ++c) {
    std::vector<Interval> intervals(1);
    for (const LoopStateId at : states) {
      const std::shared_ptr<const Worked> worked = cycle(at);
      const Turn& turn = worked->turn;
      std::vector<Interval> both;
      const automata::AllEnabled enabled = step_.enabled(state.modes, turn.action);
      for (const Interval& wait : verifier::waits(plant().components[c], state.modes[c], enabled[c], time_)) {
        for (const Interval& stay : stays(choices_of(state, turn, ComponentId(c)), state.modes[c])) {
          for (const Interval& known : intervals) {
            const Interval common = intersection(intersection(wait, stay), known);
            if (!common.empty()) both.push_back(common);
          }
        }
      }
      intervals = std::move(both);
      restless = restless || (anew[c] ? leaves_anew(turn, state.modes, c) : !turn.exits.open[c].empty());
    }
    // Time passes from the second round on with its clock at 0: in sampled time a wait that begins there is a period.
    const auto stays_at_0 = [&](const Interval& interval) {
      return interval.lower == 0 && (interval.upper > 0 || !time_.is_dense());
    };
    if (anew[c] && std::none_of(intervals.begin(), intervals.end(), stays_at_0)) return {};
    std::vector<Wait> longer;
    for (const Wait& wait : result) {
      for (const Interval& interval : intervals) {
        longer.push_back(wait);
        if (!interval.is_trivial()) longer.back().bounds.push_back({ComponentId(c), interval});
      }
    }
    result = std::move(longer);
  }
  const Box settled = settled_after(states, anew);
  for (Wait& wait : result) {
    wait.settled = settled;
    wait.endless = !restless && std::all_of(wait.bounds.begin(), wait.bounds.end(), [&](const ClockBound& b) {
      return b.clock.upper == unbounded || anew[b.component.index()];
    });
  }
  return result;
}

}  // namespace rmpl::verifier
