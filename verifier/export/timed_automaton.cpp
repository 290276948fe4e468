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

/// The modes that guards let follow each other, first come first. One combination of modes is one location or two:
/// `running` lets time pass up to the invariant; `stopped` lets none pass, for where an untimed exit is forced or a
/// bound has passed before its guard held (a timed automaton could not be there under the invariant).
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
      for (const auto& from : {states_[step.from].running, states_[step.from].stopped}) {
        if (!from) continue;
        result_.edges.push_back(step.edge);
        result_.edges.back().from = *from;
      }
    }
    return std::move(result_);
  }

 private:
  struct State {
    Modes modes;
    bool urgent = false;
    std::vector<ClockRange> invariant;
    std::optional<std::size_t> running, stopped;  ///< locations, where something leads to them
  };
  /// An edge from each location of a state.
  struct Step {
    std::size_t from;
    Edge edge;
  };

  void start() {
    base::for_each_combination(initial_modes(plant_, question_.from), [&](const Modes& modes) {
      if (const auto state = find(modes)) result_.initial.push_back(location(*state, states_[*state].urgent));
    });
  }

  /// Nothing where the modes are impossible.
  std::optional<std::size_t> find(const Modes& modes) {
    const auto [known, fresh] = numbers_.emplace(modes, std::nullopt);
    if (!fresh || !step_.possible(modes)) return known->second;
    known->second = states_.size();
    State& state = states_.emplace_back(State{modes, false, {}, {}, {}});
    const automata::AllEnabled& enabled = step_.enabled(modes, automata::idle_action(plant_));
    for (std::size_t c = 0; c < modes.size(); ++c) {
      const auto waits = verifier::waits(plant_.components[c], modes[c], enabled[c], result_.time);
      // In dense time there is one wait, from any reading on, or none, but where a fault is certain for some time.
      if (waits.empty()) {
        state.urgent = true;
      } else if (waits.front().upper != unbounded) {
        state.invariant.push_back({clocks_[c], {0, waits.front().upper}});
      }
    }
    return known->second;
  }

  std::size_t location(std::size_t number, bool stopped) {
    State& state = states_[number];
    std::optional<std::size_t>& location = stopped ? state.stopped : state.running;
    if (!location) {
      meter_.count_state();
      location = result_.locations.size();
      result_.locations.push_back({state.modes, {}, stopped, asked_for(state.modes)});
      if (!stopped) result_.locations.back().invariant = state.invariant;
    }
    return *location;
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
    edge.to = location(*to, states_[*to].urgent);
    steps_.push_back({from, edge});
    if (states_[*to].urgent) return;
    for (const ClockRange& bound : std::vector(states_[*to].invariant)) {
      if (std::count(edge.resets.begin(), edge.resets.end(), bound.clock) > 0) continue;
      // At the bound itself no time can pass either way, so that it may be taken for passed: no strict bound is needed.
      Edge overdue = edge;
      overdue.to = location(*to, true);
      overdue.guard.push_back({bound.clock, {bound.range.upper, unbounded}});
      steps_.push_back({from, std::move(overdue)});
    }
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
