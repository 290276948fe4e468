// A plant and a question as one timed automaton.
// SPDX-License-Identifier: MIT
#include "verifier/export/timed_automaton.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "automata/assignment_text.hpp"
#include "verifier/plant/joint_choices.hpp"
#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using automata::ComponentId;
using automata::ControlAction;
using automata::Modes;
using automata::Plant;

namespace {

/// The modes that guards let follow each other, first come first. One combination of modes is a location for each
/// combination of its components' waits, which lets time pass up to their ends, and one that lets none pass: for where
/// an untimed exit is forced, a bound has passed before its guard held, or a fault is certain that may not happen.
class Unfolding {
 public:
  Unfolding(automata::PlantStep& step, const ExportQuestion& question, const Limits& limits)
      : step_(step),
        plant_(step.plant()),
        question_(question),
        target_(step.theory().encode(question.target)),
        meter_(limits),
        result_{TimeModel::dense(plant_, {}), {}, {}, {}, {}, question.faults} {
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      clocks_.push_back(result_.clocks.size());
      const auto& transitions = plant_.components[c].transitions;
      const auto timed = [](const automata::Transition& t) { return t.timing.has_value(); };
      if (std::any_of(transitions.begin(), transitions.end(), timed)) result_.clocks.emplace_back(c);
    }
  }

  TimedAutomaton run() {
    start();
    // `steps_` grows while the states that it leads to are explored.
    for (std::size_t state = 0; state < states_.size(); ++state) explore(state);
    for (const Step& step : steps_) {
      for (const auto& [waits, from] : states_[step.from].locations) {
        result_.edges.push_back(step.edge);
        result_.edges.back().from = from;
      }
    }
    return std::move(result_);
  }

 private:
  /// Of each component that does not let all time pass, the wait that it is in; nothing: no time passes.
  using Waits = std::optional<std::vector<ClockRange>>;
  struct State {
    Modes modes;
    std::vector<std::pair<std::size_t, std::vector<Interval>>> waits;  ///< by clock, where time ends
    bool urgent = false;                                               ///< at any reading
    std::map<Waits, std::size_t> locations;                            ///< where something leads to them
  };
  /// An edge from each location of a state.
  struct Step {
    std::size_t from;
    Edge edge;
  };

  void start() {
    base::for_each_combination(initial_modes(plant_, question_.from), [&](const Modes& modes) {
      const auto state = find(modes);
      if (!state) return;
      const std::vector<bool> zero(result_.clocks.size(), true);
      for_each_arrival(*state, zero, [&](const Waits& waits, const std::vector<ClockRange>&) {
        result_.initial.push_back(location(*state, waits));
      });
    });
  }

  /// Nothing where the modes are impossible.
  std::optional<std::size_t> find(const Modes& modes) {
    const auto [known, fresh] = numbers_.emplace(modes, std::nullopt);
    if (!fresh || !step_.possible(modes)) return known->second;
    known->second = states_.size();
    State& state = states_.emplace_back(State{modes, {}, false, {}});
    const automata::AllEnabled& enabled = step_.enabled(modes, automata::idle_action(plant_));
    for (std::size_t c = 0; c < modes.size(); ++c) {
      auto waits = verifier::waits(plant_.components[c], modes[c], enabled[c], result_.time);
      if (waits.empty()) {
        state.urgent = true;
      } else if (!waits.front().is_trivial()) {
        state.waits.emplace_back(clocks_[c], std::move(waits));
      }
    }
    return known->second;
  }

  std::size_t location(std::size_t number, const Waits& waits) {
    State& state = states_[number];
    const auto [known, fresh] = state.locations.emplace(waits, result_.locations.size());
    if (fresh) {
      meter_.count_state();
      Location& made = result_.locations.emplace_back(Location{state.modes, {}, !waits, asked_for(state.modes)});
      if (waits) {
        for (const auto& [clock, range] : *waits) {
          if (range.upper != unbounded) made.invariant.push_back({clock, {0, range.upper}});
        }
      }
    }
    return known->second;
  }

  /// Calls visit(waits, guard) for each location that a step to the state may end in, with what the clocks must read
  /// for it; `zero`: the clocks that the step starts anew.
  template <class Visit>
  void for_each_arrival(std::size_t number, const std::vector<bool>& zero, const Visit& visit) {
    const State& state = states_[number];
    if (state.urgent) return visit(std::nullopt, {});
    std::vector<std::vector<Interval>> ways;
    std::vector<ClockRange> late;
    for (const auto& [clock, waits] : state.waits) {
      ways.push_back(waits);
      if (zero[clock]) std::erase_if(ways.back(), [](const Interval& wait) { return wait.lower > 0; });
      if (zero[clock] && ways.back().empty()) return visit(std::nullopt, {});
      if (zero[clock]) continue;
      for (const Interval& gap : gaps(waits)) late.push_back({clock, gap});
    }
    base::for_each_combination(ways, [&](const std::vector<Interval>& chosen) {
      std::vector<ClockRange> waits, guard;
      for (std::size_t w = 0; w < chosen.size(); ++w) {
        waits.push_back({state.waits[w].first, chosen[w]});
        // The invariant of the location says up to when.
        if (chosen[w].lower > 0) guard.push_back({state.waits[w].first, {chosen[w].lower, unbounded}});
      }
      visit(waits, guard);
    });
    // At the end of a wait no time can pass either way, so that it may be taken for passed: no strict bound is needed.
    for (const ClockRange& range : late) visit(std::nullopt, {range});
  }

  bool asked_for(const Modes& modes) {
    const std::vector<automata::Assignment> store = automata::assignments_of(plant_, modes);
    return question_.entailed ? step_.theory().entails(store, target_) : step_.theory().allows(store, target_);
  }

  void explore(std::size_t from) {
    const Modes modes = states_[from].modes;
    std::set<std::vector<std::vector<Choice>>> seen_choices;
    std::set<JointChoice> seen;
    for_each_action(plant_, question_.commands, [&](const ControlAction& action) {
      meter_.poll();
      const automata::AllEnabled& enabled = step_.enabled(modes, action);
      std::vector<std::vector<Choice>> all;
      for (std::size_t c = 0; c < modes.size(); ++c) {
        all.push_back(choices(plant_.components[c], modes[c], enabled[c], result_.time));
      }
      if (!seen_choices.insert(all).second) return;
      for_each_joint(all, question_.faults, [&](const JointChoice& joint) {
        meter_.poll();
        if (seen.insert(joint).second) step(from, modes, joint);
      });
    });
  }

  void step(std::size_t from, const Modes& modes, const JointChoice& joint) {
    if (joint.modes == modes) return;
    Edge edge{0, 0, {}, {}, joint.faults};
    for (const ClockBound& bound : joint.bounds) edge.guard.push_back({clocks_[bound.component.index()], bound.clock});
    for (std::size_t c = 0; c < modes.size(); ++c) {
      const bool restarts = joint.modes[c] != modes[c] && plant_.has_timed_exit(ComponentId(c), joint.modes[c]);
      if (restarts) edge.resets.push_back(clocks_[c]);
    }
    const auto to = find(joint.modes);
    if (!to) return;
    std::vector<bool> zero(result_.clocks.size(), false);
    for (const std::size_t clock : edge.resets) zero[clock] = true;
    for_each_arrival(*to, zero, [&](const Waits& waits, const std::vector<ClockRange>& guard) {
      Edge arrival = edge;
      arrival.to = location(*to, waits);
      arrival.guard.insert(arrival.guard.end(), guard.begin(), guard.end());
      steps_.push_back({from, std::move(arrival)});
    });
  }

  automata::PlantStep& step_;
  const Plant& plant_;
  const ExportQuestion& question_;
  automata::Theory::Handle target_;
  Meter meter_;
  std::vector<std::size_t> clocks_;  ///< per component, its clock where it has one
  TimedAutomaton result_;
  std::vector<State> states_;
  std::map<Modes, std::optional<std::size_t>> numbers_;
  std::vector<Step> steps_;
};

}  // namespace

TimedAutomaton unfold(automata::PlantStep& step, const ExportQuestion& question, const Limits& limits) {
  return Unfolding(step, question, limits).run();
}

std::string describe(const Plant& plant, const Modes& modes) {
  return to_text(plant.variables, automata::assignments_of(plant, modes));
}

}  // namespace rmpl::verifier
