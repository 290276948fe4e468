// The closed loop, state by state and tick by tick.
// SPDX-License-Identifier: MIT
#include "tests/reference/closed_loop.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "tests/reference/belief.hpp"
#include "tests/reference/endless.hpp"
#include "tests/reference/loop_moves.hpp"

namespace rmpl::reference {

using automata::Assignment;
using automata::ClockId;
using automata::ControlAction;
using automata::LocationId;
using automata::ModeId;
using automata::Modes;
using automata::Ticks;
using automata::Transition;

namespace {

constexpr std::size_t most_states = 20'000;
constexpr int before = -1;
constexpr int after = 1;

/// A program clock: its reading, and on which side of it the last cycle saw it. `rank` orders clocks by their start.
struct ProgramClock {
  Ticks reading;
  int side = after;
  int rank = 0;
  auto operator<=>(const ProgramClock&) const = default;
};

struct State {
  std::set<LocationId> marking;
  std::map<ClockId, ProgramClock> clocks;
  Modes modes;
  std::vector<Ticks> component_clocks;
  std::set<std::size_t> achieved;  ///< components that are still where a goal brought them, or found them
  std::size_t faults = 0;
  std::optional<Ticks> late;  ///< time so far, while what is to hold has not
  /// Of the cycle that led here, where it was without a plan: the modes that its goal spoke of.
  std::optional<std::set<automata::VariableId>> no_plan = std::nullopt;
  Adviser::Position position = 0;
  auto operator<=>(const State&) const = default;
};

/// The first half of a cycle.
struct Begun {
  Sequencer sequencer;
  std::vector<Assignment> goal;
  bool conflict;
  Advice advice;
  Modes modes;
  Adviser::Position position;
};

/// What a run through all states is for.
enum class Look { all, late, missed };

class Explorer {
 public:
  Explorer(const automata::Program& program, const Step& step, const Adviser& adviser, const LoopQuestion& question,
           Look look)
      : look_(look),
        program_(program),
        step_(step),
        plant_(step.plant()),
        adviser_(adviser),
        question_(question),
        asked_(knowledge_asked_by(program)),
        asks_for_plans_(std::any_of(asked_.begin(), asked_.end(),
                                    [](const auto& atom) { return atom.knowing == automata::Knowing::no_plan; })),
        moves_(step, question.period, question.period.value_or(question.unit)) {}

  LoopAnswer run() {
    for (const auto& [start, probability] : initial_belief(step_)) {
      State state{
          Sequencer(program_, step_.models()).marking(), {}, start.modes, start.clock_starts, {}, 0, std::nullopt};
      if (look_ == Look::late) state.late = Ticks{0};
      if (!state.late || !has_come(state.modes)) arrive(state);
    }
    for (std::size_t s = 0; s < states_.size() && states_.size() < most_states; ++s) {
      const State state = *states_[s];
      look(state);
      judged_.resize(states_.size(), false);
      if (state.marking.empty() && !state.late) continue;
      if (state.late && *state.late > question_.within) continue;
      judged_[s] = true;
      goes_on_ = false;
      if (question_.period)
        cycles(s, state, state, true);
      else
        dense(s, state);
      const bool late =
          state.late && !question_.within.is_infinite() &&
          (question_.period ? *state.late + *question_.period > question_.within : *state.late == question_.within);
      const bool some_day = state.late && question_.within.is_infinite();
      answer_.late = answer_.late || ((late || some_day) && judged_[s] && !goes_on_);
    }
    answer_.too_many = states_.size() >= most_states;
    if (look_ == Look::all && !answer_.too_many) find_endless();
    if (look_ != Look::all && !answer_.too_many && question_.within.is_infinite()) find_unanswered();
    return answer_;
  }

 private:
  /// A state, and where `then` is asked for in it, the one from which on it is owed.
  std::size_t arrive(const State& state) {
    const bool asks = look_ == Look::missed && !state.late && !has_come(state.modes) &&
                      step_.models().allows(assumptions_of(plant_, state.modes), question_.formula);
    if (asks) {
      State owed = state;
      owed.late = Ticks{0};
      number(owed);
    }
    return number(state);
  }

  std::size_t number(const State& state) {
    const auto [at, fresh] = numbers_.try_emplace(state, states_.size());
    if (fresh) states_.push_back(&at->first);
    return at->second;
  }

  void look(const State& state) {
    const auto store = assumptions_of(plant_, state.modes);
    answer_.holds = answer_.holds || step_.models().allows(store, question_.formula);
    answer_.ends_without = answer_.ends_without || (state.marking.empty() && !implies(state.modes));
    answer_.late = answer_.late || (state.late && *state.late > question_.within);
  }

  [[nodiscard]] bool implies(const Modes& modes) const {
    return step_.models().entails(assumptions_of(plant_, modes), question_.formula);
  }

  /// What is so, where the estimate is the truth, of all that the program asks of the executive's knowledge.
  [[nodiscard]] std::vector<automata::Formula> so(const State& state) const {
    const auto store = assumptions_of(plant_, state.modes);
    std::vector<automata::Formula> result;
    for (const automata::Formula& atom : asked_) {
      bool is_so = false;
      if (atom.knowing == automata::Knowing::no_plan)
        is_so = state.no_plan && (!atom.about_one || state.no_plan->contains(atom.variable));
      if (atom.knowing == automata::Knowing::possible) is_so = step_.models().allows(store, atom.operands[0]);
      if (atom.knowing == automata::Knowing::likely) is_so = step_.models().entails(store, atom.operands[0]);
      if (is_so) result.push_back(atom);
    }
    return result;
  }

  /// Of what is to hold in time.
  [[nodiscard]] bool has_come(const Modes& modes) const {
    const automata::Formula& wanted = look_ == Look::missed ? question_.then : question_.formula;
    return step_.models().entails(assumptions_of(plant_, modes), wanted);
  }

  /// `seen` is the state with its clocks on the sides from which this cycle sees them.
  Begun begin(const State& state, const State& seen) {
    Begun begun{Sequencer(program_, step_.models()), {}, false, {}, state.modes, state.position};
    std::map<ClockId, Ticks> started;
    for (const auto& [clock, c] : seen.clocks)
      started[clock] = Ticks{0} - c.reading - Ticks{question_.period ? 0 : c.side};
    begun.sequencer.resume(state.marking, started);
    begun.sequencer.know(so(state));
    const auto goal = begun.sequencer.begin(assumptions_of(plant_, state.modes), Ticks{0}).front();
    begun.conflict = goal.contradictory;
    if (!goal.contradictory) begun.goal.assign(goal.assignments.begin(), goal.assignments.end());
    const auto [at, fresh] = advice_.try_emplace({state.modes, begun.goal, state.position});
    if (fresh) at->second = adviser_.says(state.modes, begun.goal, state.position);
    begun.advice = at->second;
    if (!state.marking.empty()) {
      answer_.conflict = answer_.conflict || begun.conflict;
      answer_.no_plan = answer_.no_plan || begun.advice.no_plan;
    }
    return begun;
  }

  [[nodiscard]] State later(State state) const {
    for (auto& [clock, c] : state.clocks) {
      const bool capped = c.reading >= moves_.cap();
      if (!capped) c.reading += moves_.unit();
      c.side = capped || question_.period ? after : before;
    }
    for (std::size_t i = 0; i < state.modes.size(); ++i) {
      const auto& transitions = plant_.components[i].transitions;
      const bool timed = std::any_of(transitions.begin(), transitions.end(),
                                     [&](const Transition& t) { return t.from == state.modes[i] && t.timing; });
      if (timed) state.component_clocks[i] = std::min(state.component_clocks[i] + moves_.unit(), moves_.cap());
    }
    if (state.late && !question_.within.is_infinite()) *state.late += moves_.unit();
    return state;
  }

  /// Every outcome of one cycle. Sampled, time passes in it.
  void cycles(std::size_t from, const State& state, const State& seen, bool sampled) {
    const Begun begun = begin(state, seen);
    const State at_end = sampled ? later(seen) : seen;
    std::vector<std::vector<std::pair<ModeId, bool>>> options;
    std::vector<std::size_t> sizes;
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      options.push_back(
          moves_.choices(state.modes, c, begun.advice.action, state.component_clocks[c], at_end.component_clocks[c]));
      sizes.push_back(options.back().size());
      // Where a fault is certain it is what the budget leaves out that would come next.
      const auto is_fault = [](const auto& option) { return option.second; };
      if (std::all_of(options.back().begin(), options.back().end(), is_fault)) judged_[from] = false;
    }
    for (const auto& tuple : tuples(sizes)) {
      State next = at_end;
      bool allowed = true;
      int lasts = 2;
      for (std::size_t c = 0; c < tuple.size(); ++c) {
        const auto [mode, fault] = options[c][tuple[c]];
        lasts = std::min(lasts, moves_.lasts(state.modes, c, begun.advice.action, state.component_clocks[c], mode));
        if (mode != state.modes[c] || step_.restarts(c, state.modes, begun.advice.action))
          next.component_clocks[c] = Ticks{0};
        next.modes[c] = mode;
        next.faults += fault;
        allowed = allowed && (!fault || !question_.faults_allowed || question_.faults_allowed->contains({c, mode}));
      }
      if (!allowed) continue;
      if (next.faults > question_.faults || !step_.possible(next.modes)) continue;
      finish(next, begun, sampled);
      goes_on_ = goes_on_ || (next.faults == state.faults && (sampled || (next != state && lasts == 2)));
      if (next.late && *next.late <= question_.within && has_come(next.modes)) continue;
      achieve(state, begun, next);
      add_edge(from, state, next, sampled, begun.advice.action, lasts);
    }
  }

  /// What a cycle takes away of what was achieved, and what is achieved after it.
  void achieve(const State& state, const Begun& begun, State& next) {
    if (next.late) return;
    for (std::size_t c = 0; c < next.modes.size(); ++c) {
      const automata::Component& component = plant_.components[c];
      std::optional<ModeId> asked;
      for (const Assignment& a : begun.goal)
        if (a.variable == component.mode) asked = ModeId(a.value.index());
      const ModeId from = state.modes[c];
      const ModeId to = next.modes[c];
      const bool had = state.achieved.contains(c);
      if (had && from != to && begun.advice.for_reward && !component.modes[to.index()].fault &&
          (!asked || asked == from) && !moves_.idle_leads(state.modes, c, to))
        answer_.undone = true;
      next.achieved.erase(c);
      if (asked == to || (had && from == to)) next.achieved.insert(c);
    }
  }

  /// The second half of a cycle: marking and clocks of `next`.
  void finish(State& next, const Begun& begun, bool sampled) {
    Sequencer sequencer = begun.sequencer;
    next.no_plan.reset();
    if (begun.advice.no_plan && asks_for_plans_) {
      next.no_plan.emplace();
      for (const Assignment& goal : begun.goal) next.no_plan->insert(goal.variable);
    }
    next.position = adviser_.knows(begun.modes, begun.goal, begun.position, next.modes);
    sequencer.know(so(next));
    sequencer.finish(assumptions_of(plant_, next.modes));
    next.marking = sequencer.marking();
    std::erase_if(next.clocks, [&](const auto& known) { return !sequencer.started().contains(known.first); });
    int rank = 0;
    for (const auto& [clock, c] : next.clocks) rank = std::max(rank, c.rank + 1);
    for (const auto& [clock, start] : sequencer.started())
      if (!next.clocks.contains(clock)) next.clocks[clock] = {sampled ? moves_.unit() : Ticks{0}, after, rank};
    // Ranks only order clocks: without gaps, states that differ in nothing else are one.
    std::set<int> ranks;
    for (const auto& [clock, c] : next.clocks) ranks.insert(c.rank);
    for (auto& [clock, c] : next.clocks) c.rank = static_cast<int>(std::distance(ranks.begin(), ranks.find(c.rank)));
  }

  void add_edge(std::size_t from, const State& state, const State& next, bool time, const ControlAction& action,
                int lasts = 2) {
    std::vector<bool> moves;
    for (std::size_t c = 0; c < state.modes.size(); ++c)
      moves.push_back(state.modes[c] != next.modes[c] || step_.restarts(c, state.modes, action));
    edges_.push_back({from, arrive(next), time, state.faults == next.faults, std::move(moves),
                      &moves_.exits(state.modes, action), lasts});
  }

  void dense(std::size_t from, const State& state) {
    // Every way of seeing the clocks: each start has one side, none falls back.
    std::set<int> ranks;
    for (const auto& [clock, c] : state.clocks) ranks.insert(c.rank);
    const std::vector<std::size_t> sizes(ranks.size(), 3);
    for (const auto& tuple : tuples(sizes)) {
      State seen = state;
      bool right = true;
      for (auto& [clock, c] : seen.clocks) {
        const auto start = static_cast<std::size_t>(std::distance(ranks.begin(), ranks.find(c.rank)));
        const int side = static_cast<int>(tuple[start]) - 1;
        right = right && side >= c.side && (c.reading > Ticks{0} || side == after);
        c.side = side;
      }
      for (const auto& [one, a] : seen.clocks)
        for (const auto& [other, b] : seen.clocks)
          if (a.rank < b.rank && a.reading == b.reading)
            right = right && (a.side > b.side || (a.side == b.side && a.side != 0));
      if (right) cycles(from, state, seen, false);
    }
    if (const auto round = idles(state)) {
      goes_on_ = true;
      State next = later(state);
      for (const std::size_t c : round->anew) next.component_clocks[c] = Ticks{0};
      for (const ClockId clock : round->restarted) next.clocks[clock] = {Ticks{0}, after, next.clocks[clock].rank};
      if (!next.late || *next.late > question_.within || !has_come(next.modes))
        add_edge(from, state, next, true, round->action);
    }
  }

  /// Cycles that go round while the plant stays as it is.
  struct Round {
    ControlAction action;         ///< of the first of them
    std::set<ClockId> restarted;  ///< clocks that start anew each time
    std::set<std::size_t> anew;   ///< components whose clocks do
  };

  /// Whether cycles go round for a unit of time.
  std::optional<Round> idles(const State& state) {
    State seen = state;
    for (auto& [clock, c] : seen.clocks) c.side = after;
    const State start = seen;
    std::set<State> met;
    std::optional<Round> result;
    while (met.insert(seen).second) {
      const Begun begun = begin(seen, seen);
      if (!result) result = Round{begun.advice.action, {}, {}};
      for (std::size_t c = 0; c < plant_.components.size(); ++c) {
        bool stays = false, due = false;
        for (const Transition* t : moves_.enabled(seen.modes, c, begun.advice.action)) {
          if (plant_.components[c].is_fault(*t)) continue;
          if (t->weight.kind != automata::Weight::Kind::none && t->weight.value <= 0) continue;
          const bool leaves = t->to != seen.modes[c];
          if (!t->timing && leaves) return std::nullopt;
          if (!t->timing) stays = true;
          if (t->timing && leaves && seen.component_clocks[c] >= t->timing->upper) due = true;
        }
        if (due && !stays) return std::nullopt;
        const auto options =
            moves_.choices(seen.modes, c, begun.advice.action, seen.component_clocks[c], seen.component_clocks[c]);
        if (std::find(options.begin(), options.end(), std::pair(seen.modes[c], false)) == options.end())
          return std::nullopt;
      }
      for (std::size_t c = 0; c < plant_.components.size(); ++c)
        if (step_.restarts(c, seen.modes, begun.advice.action)) {
          seen.component_clocks[c] = Ticks{0};
          result->anew.insert(c);
        }
      finish(seen, begun, false);
      for (const auto& [clock, c] : start.clocks)
        if (!seen.clocks.contains(clock)) result->restarted.insert(clock);
    }
    return seen == start ? result : std::nullopt;
  }

  void find_endless() {
    answer_.runs_for_ever = runs_for_ever(edges_, plant_.components.size());
    judged_.resize(states_.size(), false);
    answer_.stops = comes_to_a_stop(edges_, judged_);
    // Waiting: time alone goes by in one state, or, in dense time, while the marking goes round.
    for (const RunEdge& e : edges_) {
      const bool stays = e.to == e.from && e.time;
      const bool shut = !question_.period || is_shut(*e.exits);
      if (stays && shut && round_is_shut(*states_[e.from])) answer_.waits_for_ever = true;
    }
  }

  /// Runs that go on for ever while something is owed that may come some day.
  void find_unanswered() {
    std::vector<RunEdge> owed;
    for (const RunEdge& e : edges_)
      if (states_[e.from]->late && states_[e.to]->late) owed.push_back(e);
    answer_.late = answer_.late || runs_for_ever(owed, plant_.components.size());
  }

  static bool is_shut(const Exits& exits) {
    return std::all_of(exits.open.begin(), exits.open.end(), [](const auto& open) { return open.empty(); });
  }

  /// Whether in all cycles of a round no component could leave its mode at last.
  bool round_is_shut(const State& state) {
    State seen = state;
    for (auto& [clock, c] : seen.clocks) c.side = after;
    const State start = seen;
    std::set<std::size_t> anew;
    std::vector<ControlAction> actions;
    do {
      const Begun begun = begin(seen, seen);
      actions.push_back(begun.advice.action);
      for (std::size_t c = 0; c < plant_.components.size(); ++c)
        if (step_.restarts(c, seen.modes, begun.advice.action)) anew.insert(c);
      finish(seen, begun, false);
    } while (seen != start);
    return std::all_of(actions.begin(), actions.end(), [&](const ControlAction& action) {
      const Exits& exits = moves_.exits(state.modes, action);
      for (std::size_t c = 0; c < exits.open.size(); ++c) {
        if (!anew.contains(c) && !exits.open[c].empty()) return false;
        if (!anew.contains(c)) continue;
        // Its clock reads 0 all the while.
        const Ticks end = question_.period ? moves_.unit() : Ticks{0};
        for (const auto& [mode, fault] : moves_.choices(state.modes, c, action, Ticks{0}, end))
          if (!fault && exits.open[c].contains(mode)) return false;
      }
      return true;
    });
  }

  Look look_;
  const automata::Program& program_;
  const Step& step_;
  const automata::Plant& plant_;
  const Adviser& adviser_;
  const LoopQuestion& question_;
  const std::vector<automata::Formula> asked_;
  const bool asks_for_plans_;
  LoopMoves moves_;
  LoopAnswer answer_;
  bool goes_on_ = false;  ///< what is looked at
  std::map<State, std::size_t> numbers_;
  std::vector<const State*> states_;
  std::vector<bool> judged_;  ///< by state: it was explored, and no fault is certain in it
  std::vector<RunEdge> edges_;
  std::map<std::tuple<Modes, std::vector<Assignment>, Adviser::Position>, Advice> advice_;
};

}  // namespace

LoopAnswer explore_loop(const automata::Program& program, const Step& step, const Adviser& adviser,
                        const LoopQuestion& question) {
  LoopAnswer answer = Explorer(program, step, adviser, question, Look::all).run();
  const LoopAnswer timed = Explorer(program, step, adviser, question, Look::late).run();
  const LoopAnswer owed = Explorer(program, step, adviser, question, Look::missed).run();
  answer.late = timed.late;
  answer.missed = owed.late;
  LoopQuestion some_day = question;
  some_day.within = Ticks::infinite();
  const LoopAnswer never = Explorer(program, step, adviser, some_day, Look::late).run();
  const LoopAnswer unanswered = Explorer(program, step, adviser, some_day, Look::missed).run();
  answer.never_comes = never.late;
  answer.never_answered = unanswered.late;
  answer.too_many = answer.too_many || timed.too_many || owed.too_many || never.too_many || unanswered.too_many;
  return answer;
}

}  // namespace rmpl::reference
