// Reachability by explicit search, tick by tick.
// SPDX-License-Identifier: MIT
#include "tests/reference/reachability.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <set>

#include "tests/reference/belief.hpp"
#include "tests/reference/endless.hpp"
#include "tests/reference/loop_moves.hpp"

namespace rmpl::reference {

using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::Ticks;
using automata::Transition;

namespace {

struct State {
  Modes modes;
  std::vector<Ticks> clocks;
  std::size_t faults = 0;
  std::optional<Ticks> waiting = std::nullopt;  ///< for the response: time since `after` held, unanswered
  auto operator<=>(const State&) const = default;
};

/// What one component may do in a step.
struct Choice {
  ModeId mode;
  std::size_t faults;
  int lasts = 2;  ///< see RunEdge
};

std::vector<ControlAction> actions_of(const automata::Plant& plant, Question::Commands commands) {
  std::vector<std::size_t> sizes;
  for (const automata::Control& control : plant.controls)
    sizes.push_back(plant.variables[control.variable].values.size());
  std::vector<ControlAction> result;
  for (const auto& tuple : tuples(sizes)) {
    ControlAction action;
    std::size_t off_idle = 0;
    for (std::size_t i = 0; i < tuple.size(); ++i) {
      action.emplace_back(tuple[i]);
      off_idle += action.back() != plant.controls[i].idle;
    }
    const bool allowed =
        off_idle == 0 || (off_idle == 1 && commands == Question::Commands::one) || commands == Question::Commands::any;
    if (allowed) result.push_back(action);
  }
  return result;
}

/// A search over states in order of the steps that change a mode; `Reading` says how time passes and what may happen.
class Search {
 public:
  Search(const Step& step, const Question& question)
      : step_(step), plant_(step.plant()), question_(question), actions_(actions_of(plant_, question.commands)) {
    for (const automata::Component& component : plant_.components)
      for (const Transition& t : component.transitions)
        if (t.timing) {
          cap_ = std::max(cap_, t.timing->lower);
          if (!t.timing->upper.is_infinite()) cap_ = std::max(cap_, t.timing->upper);
        }
  }
  virtual ~Search() = default;

  std::optional<std::size_t> run() {
    std::deque<std::pair<State, std::size_t>> queue;  // states at n steps, then those at n + 1
    for (const auto& [start, probability] : initial_belief(step_))
      queue.emplace_back(enter({start.modes, start.clock_starts}), 0);
    std::set<State> seen;
    while (!queue.empty()) {
      const auto [state, steps] = queue.front();
      queue.pop_front();
      if (!seen.insert(state).second) continue;
      if (accepts(state)) return steps;
      bool goes_on = false;
      successors(state, [&, &from = state, n = steps](const State& target) {
        const State next = enter(target);
        goes_on = goes_on || (next.faults == from.faults && lasts_ == 2);
        if (next.modes == from.modes)
          queue.emplace_front(next, n);
        else
          queue.emplace_back(next, n + 1);
      });
      const bool missed = !goes_on && state.waiting && question_.response->stuck_misses &&
                          next_is_late(*state.waiting, question_.response->within);
      if (missed && !some_fault_is_certain(state)) return steps;
    }
    return std::nullopt;
  }

  bool stops() {
    const Explored all = explore(nullptr);
    return comes_to_a_stop(all.edges, all.judged);
  }

  bool exceeds_faults() {
    const Explored all = explore(nullptr);
    return std::find(all.judged.begin(), all.judged.end(), false) != all.judged.end();
  }

  bool never_answers(LoopMoves& moves) {
    const Explored all = explore(&moves);
    std::vector<bool> goes_on(all.judged.size(), false);
    std::vector<RunEdge> owed;
    for (const RunEdge& edge : all.edges) {
      if (edge.nominal && edge.lasts == 2) goes_on[edge.from] = true;
      if (all.states[edge.from].waiting && all.states[edge.to].waiting) owed.push_back(edge);
    }
    for (std::size_t s = 0; s < goes_on.size(); ++s)
      if (all.states[s].waiting && all.judged[s] && !goes_on[s]) return true;
    return runs_for_ever(owed, plant_.components.size());
  }

 protected:
  /// All states and steps; `judged` where no fault is certain.
  struct Explored {
    std::vector<State> states;
    std::vector<RunEdge> edges;
    std::vector<bool> judged;
  };

  /// `moves`: what tells of exits; none where they do not matter.
  Explored explore(LoopMoves* moves) {
    Explored result;
    std::map<State, std::size_t> numbers;
    const auto number = [&](const State& state) {
      const auto [at, fresh] = numbers.try_emplace(state, numbers.size());
      if (fresh) result.states.push_back(state);
      return at->second;
    };
    for (const auto& [start, probability] : initial_belief(step_)) number(enter({start.modes, start.clock_starts}));
    for (std::size_t s = 0; s < result.states.size(); ++s) {
      const State state = result.states[s];
      result.judged.push_back(!some_fault_is_certain(state));
      successors(state, [&](const State& target) {
        const State next = enter(target);
        std::vector<bool> changes;
        for (std::size_t c = 0; c < state.modes.size(); ++c)
          changes.push_back(state.modes[c] != next.modes[c] || step_.restarts(c, state.modes, action_));
        // A command of an instant keeps nothing from staying enabled.
        const Exits* exits = moves == nullptr || !takes_time_ ? nullptr : &moves->exits(state.modes, action_);
        result.edges.push_back(
            {s, number(next), takes_time_, next.faults == state.faults, std::move(changes), exits, lasts_});
      });
    }
    return result;
  }

  using Visit = std::function<void(const State&)>;
  virtual void successors(const State& state, const Visit& visit) = 0;
  /// Whether what follows now, at the soonest, would come too late.
  [[nodiscard]] virtual bool next_is_late(Ticks waiting, Ticks within) const { return waiting == within; }
  /// The state with its clocks as a step sees them.
  [[nodiscard]] virtual State at_end(const State& state) const { return state; }
  [[nodiscard]] ControlAction idle() const {
    ControlAction action;
    for (const automata::Control& control : plant_.controls) action.push_back(control.idle);
    return action;
  }
  /// What a component may do under an action; empty where it can do nothing at all.
  virtual std::vector<Choice> choices(const State& state, std::size_t component, const ControlAction& action) = 0;

  /// Every joint choice within the fault budget whose target is possible; clocks as they are, started anew on a change,
  /// and by a restart.
  void moves(const State& state, const ControlAction& action, const Visit& visit) {
    std::vector<std::vector<Choice>> options;
    std::vector<std::size_t> sizes;
    for (std::size_t i = 0; i < plant_.components.size(); ++i) {
      options.push_back(choices(state, i, action));
      sizes.push_back(options.back().size());
    }
    for (const auto& tuple : tuples(sizes)) {
      State next = state;
      lasts_ = 2;
      for (std::size_t i = 0; i < tuple.size(); ++i) {
        const Choice& choice = options[i][tuple[i]];
        lasts_ = std::min(lasts_, choice.lasts);
        if (choice.mode != state.modes[i] || step_.restarts(i, state.modes, action)) next.clocks[i] = Ticks{0};
        next.modes[i] = choice.mode;
        next.faults += choice.faults;
      }
      if (next.faults <= question_.faults && step_.possible(next.modes)) visit(next);
    }
  }

  /// All clocks later by `by`. Beyond every finite bound one reading is like another, and a clock that no exit of its
  /// mode reads may as well stand still.
  [[nodiscard]] State later(State state, Ticks by) const {
    for (std::size_t i = 0; i < state.clocks.size(); ++i) {
      const auto& transitions = plant_.components[i].transitions;
      if (std::any_of(transitions.begin(), transitions.end(),
                      [&](const Transition& t) { return t.from == state.modes[i] && t.timing; }))
        state.clocks[i] = std::min(state.clocks[i] + by, cap_ + by);
    }
    if (state.waiting && !question_.response->within.is_infinite()) *state.waiting += by;
    return state;
  }

  [[nodiscard]] std::vector<const Transition*> enabled(const Modes& modes, std::size_t component,
                                                       const ControlAction& action) const {
    std::vector<const Transition*> result;
    for (const Transition& t : plant_.components[component].transitions)
      if (t.from == modes[component] && step_.enabled(t, modes, action)) result.push_back(&t);
    return result;
  }

  const Step& step_;
  const automata::Plant& plant_;
  const Question& question_;
  std::vector<ControlAction> actions_;
  bool takes_time_ = true;  ///< what is visited does
  ControlAction action_;    ///< under which it is visited
  int lasts_ = 2;           ///< what is visited: see RunEdge

 private:
  /// Under idle controls.
  bool some_fault_is_certain(const State& state) {
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      const auto options = choices(at_end(state), c, idle());
      if (std::all_of(options.begin(), options.end(), [](const Choice& choice) { return choice.faults > 0; }))
        return true;
    }
    return false;
  }

  /// The state with what it means for the response.
  [[nodiscard]] State enter(State state) const {
    if (!question_.response) return state;
    if (!state.waiting && holds(state.modes, question_.response->after, question_.entailed)) state.waiting = Ticks{0};
    const bool in_time = state.waiting && *state.waiting <= question_.response->within;
    if (in_time && holds(state.modes, question_.response->then, !question_.entailed)) state.waiting.reset();
    return state;
  }

  [[nodiscard]] bool accepts(const State& state) const {
    if (question_.response) return state.waiting && *state.waiting > question_.response->within;
    return holds(state.modes, question_.target, question_.entailed);
  }

  [[nodiscard]] bool holds(const Modes& modes, const automata::Formula& formula, bool entailed) const {
    const auto store = assumptions_of(plant_, modes);
    return entailed ? step_.models().entails(store, formula) : step_.models().allows(store, formula);
  }

  Ticks cap_;
};

/// Whether a transition is a nominal one without time bounds that can be taken.
bool is_untimed_nominal(const automata::Component& component, const Transition& t) {
  const bool weightless = t.weight.kind != automata::Weight::Kind::none && t.weight.value <= 0;
  return !component.is_fault(t) && !t.timing && !weightless;
}

bool within_bounds(const Transition& fault, Ticks clock) {
  return !fault.timing || (fault.timing->lower <= clock && clock <= fault.timing->upper);
}

class Dense : public Search {
 public:
  Dense(const Step& step, const Question& question, Ticks unit) : Search(step, question), unit_(unit) {}

 protected:
  void successors(const State& state, const Visit& visit) override {
    takes_time_ = true;
    action_ = idle();
    lasts_ = 2;
    if (time_may_pass(state)) {
      State next = later(state, unit_);
      for (std::size_t i = 0; i < next.clocks.size(); ++i)
        if (step_.restarts(i, state.modes, action_)) next.clocks[i] = Ticks{0};
      visit(next);
    }
    takes_time_ = false;
    for (const ControlAction& action : actions_) {
      action_ = action;
      moves(state, action, [&](const State& next) {
        if (next.modes != state.modes || next.clocks != state.clocks) visit(next);
      });
    }
  }

  std::vector<Choice> choices(const State& state, std::size_t component, const ControlAction& action) override {
    const automata::Component& automaton = plant_.components[component];
    std::vector<Choice> result;
    double fault_sum = 0;
    bool untimed = false;
    std::vector<Choice> nominal;
    for (const Transition* t : enabled(state.modes, component, action)) {
      if (automaton.is_fault(*t)) {
        if (t->weight.value <= 0 || !within_bounds(*t, state.clocks[component])) continue;
        result.push_back({t->to, 1});
        if (t->weight.kind == automata::Weight::Kind::probability) fault_sum += t->weight.value;
      } else if (is_untimed_nominal(automaton, *t)) {
        untimed = true;
      }
    }
    // An exit whose bound is passed (its guard came to hold late) is certain: only certain ones are possible, now.
    const Ticks clock = state.clocks[component];
    bool passed = false;
    bool due = false;
    for (const Transition* t : enabled(state.modes, component, action)) {
      passed = passed || (!automaton.is_fault(*t) && t->timing && clock > t->timing->upper);
      due = due || (!automaton.is_fault(*t) && t->timing && clock >= t->timing->upper);
    }
    // At a bound an exit is taken in the cycle that ends there, and one that begins to be possible is not.
    const auto lasts = [&](const Transition& t) {
      if (untimed) return 2;
      if (due) return clock >= t.timing->upper ? 2 : 0;
      return Ticks{0} < clock && clock == t.timing->lower && may_rest(state) ? 1 : 2;
    };
    for (const Transition* t : enabled(state.modes, component, action)) {
      if (automaton.is_fault(*t)) continue;
      const bool timed = t->timing && clock >= (passed ? t->timing->upper : t->timing->lower);
      if (untimed ? is_untimed_nominal(automaton, *t) : timed) nominal.push_back({t->to, 0, lasts(*t)});
    }
    if (!untimed && !passed) nominal.push_back({state.modes[component], 0, due ? 0 : 2});
    if (fault_sum < 1) result.insert(result.end(), nominal.begin(), nominal.end());
    return result;
  }

 private:
  /// Whether no component has to leave its mode whatever its clock reads, with every control idle.
  bool may_rest(const State& state) {
    for (std::size_t i = 0; i < plant_.components.size(); ++i)
      for (const Transition* t : enabled(state.modes, i, idle()))
        if (is_untimed_nominal(plant_.components[i], *t) && t->to != state.modes[i]) return false;
    return true;
  }

  /// With every control idle: no untimed nominal transition to another mode is enabled, no faults to other modes are
  /// certain, and no timed transition to another mode has reached its upper bound, unless an untimed one to its own
  /// mode takes all of the nominal share.
  bool time_may_pass(const State& state) {
    for (std::size_t i = 0; i < plant_.components.size(); ++i) {
      bool stays = false;
      bool due = false;
      double faults = 0;
      for (const Transition* t : enabled(state.modes, i, idle())) {
        const bool leaves = t->to != state.modes[i];
        if (plant_.components[i].is_fault(*t)) {
          const bool counts =
              t->weight.kind == automata::Weight::Kind::probability && within_bounds(*t, state.clocks[i]);
          if (counts) faults += leaves ? t->weight.value : -1;
          continue;
        }
        if (is_untimed_nominal(plant_.components[i], *t)) {
          if (leaves) return false;
          stays = true;
        } else if (t->timing && leaves && state.clocks[i] >= t->timing->upper) {
          due = true;
        }
      }
      if ((due && !stays) || faults >= 1) return false;
    }
    return true;
  }

  Ticks unit_;
};

class Sampled : public Search {
 public:
  Sampled(const Step& step, const Question& question, Ticks period) : Search(step, question), period_(period) {}

 protected:
  void successors(const State& state, const Visit& visit) override {
    for (const ControlAction& action : actions_) {
      action_ = action;
      moves(at_end(state), action, visit);
    }
  }

  [[nodiscard]] State at_end(const State& state) const override { return later(state, period_); }
  [[nodiscard]] bool next_is_late(Ticks waiting, Ticks within) const override { return waiting + period_ > within; }

  /// `state` has its clocks at the end b of the step; they were b - period at its beginning.
  std::vector<Choice> choices(const State& state, std::size_t component, const ControlAction& action) override {
    const automata::Component& automaton = plant_.components[component];
    const Ticks b = state.clocks[component];
    std::vector<Choice> faults;
    std::vector<Choice> untimed;
    std::vector<Choice> timed;
    std::vector<Choice> certain;
    double fault_sum = 0;
    for (const Transition* t : enabled(state.modes, component, action)) {
      if (automaton.is_fault(*t)) {
        if (t->weight.value <= 0 || !within_bounds(*t, b)) continue;
        faults.push_back({t->to, 1});
        fault_sum += t->weight.kind == automata::Weight::Kind::rate ? 1 - std::exp(-t->weight.value * period_.seconds())
                                                                    : t->weight.value;
      } else if (is_untimed_nominal(automaton, *t)) {
        untimed.push_back({t->to, 0});
      } else if (t->timing) {
        if (b >= t->timing->upper) certain.push_back({t->to, 0});
        if (b > t->timing->lower) timed.push_back({t->to, 0});
      }
    }
    if (fault_sum >= 1) return faults;
    std::vector<Choice> result = faults;
    const auto add = [&](const std::vector<Choice>& more) { result.insert(result.end(), more.begin(), more.end()); };
    if (!untimed.empty()) {
      add(untimed);
    } else if (!certain.empty()) {
      add(certain);  // beside a survival of 0, a finite hazard has no share
    } else {
      add(timed);
      result.push_back({state.modes[component], 0});
    }
    return result;
  }

 private:
  Ticks period_;
};

}  // namespace

std::optional<std::size_t> fewest_steps_sampled(const Step& step, const Question& question, Ticks period) {
  return Sampled(step, question, period).run();
}

bool never_answers(const Step& step, const Question& question, std::optional<Ticks> period, Ticks unit) {
  LoopMoves moves(step, period, period.value_or(unit));
  return period ? Sampled(step, question, *period).never_answers(moves)
                : Dense(step, question, unit).never_answers(moves);
}

bool comes_to_a_stop(const Step& step, const Question& question, std::optional<Ticks> period, Ticks unit) {
  return period ? Sampled(step, question, *period).stops() : Dense(step, question, unit).stops();
}

bool exceeds_faults(const Step& step, const Question& question, std::optional<Ticks> period, Ticks unit) {
  return period ? Sampled(step, question, *period).exceeds_faults() : Dense(step, question, unit).exceeds_faults();
}

std::optional<std::size_t> fewest_steps_dense(const Step& step, const Question& question, Ticks unit) {
  return Dense(step, question, unit).run();
}

}  // namespace rmpl::reference
