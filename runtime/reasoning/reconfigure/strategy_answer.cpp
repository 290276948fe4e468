// From games and their solutions to commands, expected states and reasons.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/strategy_answer.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "runtime/reasoning/game/barrier.hpp"
#include "runtime/reasoning/nominal/idling.hpp"
#include "runtime/reasoning/reconfigure/course.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Modes;

namespace {

using Purpose = GameDecision::Purpose;

class Answering {
 public:
  Answering(automata::PlantStep& step, const NominalGraph& graph, Strategist& strategist, const Modes& modes,
            const StrategyPosition& position)
      : step_(step), graph_(graph), strategist_(strategist), modes_(modes), position_(position) {}

  std::optional<Reconfiguration> run() {
    const Strategist::Answer answer = strategist_.from(modes_, position_);
    if (!answer.solved) return std::nullopt;
    if (answer.rank == Rank::none) return refused(answer.groups.front());
    ControlAction action = answer.action;
    const std::vector<PursuedReward> rewards = pursued(answer, action);
    std::vector<Course> courses;
    for (const SolvedGame& group : answer.groups) courses.emplace_back(group);
    for (const PursuedReward& reward : rewards) courses.emplace_back(reward);
    auto result = told(courses, std::move(action));
    if (!result) return result;
    result->sure = answer.rank == Rank::sure;
    result->why.proved_best = answer.best;
    result->bounds_counted = answer.bounds_counted;
    result->edges = strategist_.edges(answer, modes_, result->action);
    return result;
  }

 private:
  /// Rewards are pursued where the goal is kept, and while all that is under way waits.
  std::vector<PursuedReward> pursued(const Strategist::Answer& answer, ControlAction& action) {
    for (const SolvedGame& group : answer.groups) {
      const Course course(group);
      if (group.decision().purpose == Purpose::hold) return {};
      if (course.under_way() && course.edge() != nullptr && !course.edge()->waits) return {};
    }
    return strategist_.rewards(modes_, answer, action);
  }

  /// Nothing where no outcome is possible at all: components that no game is about are stuck.
  std::optional<Reconfiguration> told(const std::vector<Course>& courses, ControlAction action) {
    Reconfiguration result;
    const ControlAction rest = resting_action(step_, modes_);
    const Course* awaited = soonest(courses);
    const Course* leading = leader(courses, action != rest, awaited);
    if (leading == nullptr) {
      result = at_rest(step_, modes_);
      result.goal_state = modes_;
      return result;
    }
    result.outcome = action == rest ? Reconfiguration::Outcome::wait : Reconfiguration::Outcome::command;
    result.action = std::move(action);
    result.expected = after(courses, awaited, result.action);
    if (!result.expected) return std::nullopt;
    result.goal_state = modes_;
    for (const Course& course : courses) put(course, course.end(), *result.goal_state);
    for (const Course& course : courses) result.irreversible = result.irreversible || irreversible(course);
    explain(*leading, result);
    return result;
  }

  /// The course that the answer is about: the first that is under way and sends something, else the first that does;
  /// where none does, what is awaited. None where there is nothing to do.
  static const Course* leader(const std::vector<Course>& courses, bool commands, const Course* awaited) {
    for (const bool under_way : {true, false}) {
      for (const Course& course : courses) {
        if (commands && course.under_way() == under_way && !course.rests()) return &course;
      }
    }
    return awaited;
  }

  /// Of the courses that are under way the one whose next outcome comes first.
  static const Course* soonest(const std::vector<Course>& courses) {
    const Course* result = nullptr;
    std::pair<std::int64_t, std::int64_t> least;
    for (const Course& course : courses) {
      const Game::Outcome* next = course.under_way() ? course.expected(course.start()) : nullptr;
      if (next == nullptr) continue;
      const std::pair<std::int64_t, std::int64_t> time{next->cost.unbounded, next->cost.time};
      if (result != nullptr && least <= time) continue;
      result = &course;
      least = time;
    }
    return result;
  }

  void put(const Course& course, std::uint32_t node, Modes& modes) const {
    for (std::size_t m = 0; m < course.game().arena().components().size(); ++m)
      modes[course.game().arena().components()[m].index()] = course.mode(node, m);
  }

  /// Whether a course that rests gives way to a reward whose game keeps its part of the goal.
  static bool is_replaced(const Course& course, const std::vector<Course>& courses) {
    const auto& own = course.game().arena().components();
    return !course.under_way() && std::any_of(courses.begin(), courses.end(), [&](const Course& other) {
      const auto& components = other.game().arena().components();
      return other.solved() == nullptr && std::includes(components.begin(), components.end(), own.begin(), own.end());
    });
  }

  /// What follows if nothing fails: the first combination of outcomes that the model permits. Where all wait, what is
  /// awaited comes, where there is such a thing.
  std::optional<Modes> after(const std::vector<Course>& courses, const Course* awaited, const ControlAction& action) {
    using Change = std::vector<std::pair<ComponentId, ModeId>>;
    std::vector<std::vector<Change>> choices;
    std::vector<bool> played(modes_.size());
    const auto add = [&](const Course& course) {
      auto& outcomes = choices.emplace_back();
      for (const Game::Outcome* outcome : course.outcomes(course.start())) {
        Change& change = outcomes.emplace_back();
        for (std::size_t m = 0; m < course.game().arena().components().size(); ++m)
          change.emplace_back(course.game().arena().components()[m], course.mode(outcome->node, m));
      }
      return !outcomes.empty();
    };
    for (const Course& course : courses) {
      for (const ComponentId c : course.game().arena().components()) played[c.index()] = true;
      const bool acts = course.edge() != nullptr && !course.edge()->waits && !is_replaced(course, courses);
      if (acts && !add(course)) return std::nullopt;
    }
    // Components that no game is about do what they have to.
    for (const ComponentId c : graph_.components()) {
      if (played[c.index()]) continue;
      const automata::Enabled& enabled = step_.enabled(c, modes_, action);
      const auto& transitions = step_.plant()[c].transitions;
      std::vector<Change> options;
      for (const automata::TransitionId t : enabled.untimed) options.push_back({{c, transitions[t.index()].to}});
      const bool stays = std::any_of(options.begin(), options.end(),
                                     [&](const Change& o) { return o.front().second == modes_[c.index()]; });
      if (!options.empty() && !stays) choices.push_back(std::move(options));
    }
    if (choices.empty() && awaited != nullptr && !add(*awaited)) return std::nullopt;
    return first_possible(choices);
  }

  /// One choice of each, like an odometer whose first wheel turns fastest.
  template <class Choices>
  std::optional<Modes> first_possible(const Choices& choices) {
    constexpr std::size_t most_tries = 4096;
    std::vector<std::size_t> chosen(choices.size());
    for (std::size_t tries = 0; tries < most_tries; ++tries) {
      Modes next = modes_;
      for (std::size_t i = 0; i < choices.size(); ++i) {
        for (const auto& [c, m] : choices[i][chosen[i]]) next[c.index()] = m;
      }
      if (step_.possible(next)) return next;
      std::size_t i = 0;
      while (i < chosen.size() && ++chosen[i] == choices[i].size()) chosen[i++] = 0;
      if (i == chosen.size()) break;
    }
    return std::nullopt;
  }

  static bool irreversible(const Course& course) {
    const Game::Edge* edge = course.edge();
    const Game::Outcome* outcome = course.expected(course.start());
    const Position::Action* action = edge == nullptr ? nullptr : course.position().find(edge->action);
    if (outcome == nullptr || action == nullptr || edge->waits) return false;
    for (std::size_t m = 0; m < action->moves.size(); ++m) {
      if (course.mode(course.start(), m) == course.mode(outcome->node, m)) continue;
      const LocalMoves::Exit* exit = exit_to(course, *action, m, outcome->node);
      if (exit != nullptr && exit->irreversible) return true;
    }
    return false;
  }

  /// The member that the step is about: one that moves as it would not at rest, else the first that moves; of a command
  /// that is held, the first on which it bears.
  static std::optional<std::size_t> moved(const Course& course, std::uint32_t node) {
    const Game::Edge* edge = course.edge();
    const Position::Action* action = edge == nullptr ? nullptr : course.position().find(edge->action);
    if (action == nullptr) return std::nullopt;
    const Position::Action& rest = course.position().actions.front();
    std::optional<std::size_t> first, borne;
    for (std::size_t m = 0; m < action->moves.size(); ++m) {
      const bool commanded = action->moves[m] != rest.moves[m];
      if (commanded && !borne) borne = m;
      if (course.mode(course.start(), m) == course.mode(node, m)) continue;
      if (commanded) return m;
      if (!first) first = m;
    }
    return first ? first : borne;
  }

  void explain(const Course& course, Reconfiguration& result) const {
    const auto& components = course.game().arena().components();
    const Game::Outcome* outcome = course.expected(course.start());
    const std::uint32_t next = outcome == nullptr ? course.start() : outcome->node, end = course.end();
    Reason& why = result.why;
    why.purpose = course.solved() != nullptr ? Reason::Purpose::goal : Reason::Purpose::reward;
    const auto member = moved(course, next);
    if (member) {
      result.component = components[*member];
      const Position::Action* action = course.position().find(course.edge()->action);
      const LocalMoves::Exit* exit = exit_to(course, *action, *member, next);
      if (exit != nullptr && course.mode(course.start(), *member) != course.mode(next, *member))
        why.step = TransitionOf{components[*member], exit->transition};
    }
    std::optional<std::size_t> served = member;
    if (course.solved() != nullptr) {
      const auto part = course.open_part(strategist_, member);
      why.conjunct = static_cast<std::uint32_t>(course.solved()->parts[part]);
      const auto& read = course.game().arena().goal().read_by(course.solved()->parts[part]);
      for (std::size_t m = 0; m < components.size(); ++m) {
        const bool reads = std::find(read.begin(), read.end(), components[m]) != read.end();
        if (!reads || course.mode(course.start(), m) == course.mode(end, m)) continue;
        served = m;
        break;
      }
    } else {
      for (std::size_t m = 0; m < components.size(); ++m) {
        const auto& arena = course.game().arena();
        if (arena.reward(m, course.mode(end, m)) <= arena.reward(m, course.mode(course.start(), m))) continue;
        served = m;
        break;
      }
    }
    if (!served) return;
    why.component = components[*served];
    why.aim = course.mode(end, *served);
  }

  /// No plan, for what no strategy may do.
  Reconfiguration refused(const SolvedGame& group) {
    const automata::Plant& plant = step_.plant();
    Reconfiguration result;
    result.outcome = Reconfiguration::Outcome::no_plan;
    result.action = resting_action(step_, modes_);
    const Course course(group);
    result.why.purpose = Reason::Purpose::goal;
    result.why.conjunct = static_cast<std::uint32_t>(group.parts[course.open_part(strategist_, std::nullopt)]);
    const auto harm = barrier(*group.game, group.start);
    if (!harm || harm->modes.empty()) {
      result.why.obstacle = Reason::Obstacle::not_found;
      result.reason = "whatever is commanded, no run leads to the goal";
      return result;
    }
    const auto name = [&](std::size_t i) {
      const auto& [c, m] = harm->modes[i];
      return "'" + plant[c].modes[m.index()].name + "'";
    };
    const ComponentId c = harm->modes.front().first;
    result.component = c;
    result.why.component = c;
    if (harm->excluded) {
      result.why.obstacle = Reason::Obstacle::side_effect;
      result.reason = "every sequence of commands to the goal risks ";
      for (std::size_t i = 0; i < harm->modes.size(); ++i) {
        result.reason += (i == 0                        ? "'"
                          : i + 1 == harm->modes.size() ? " and '"
                                                        : ", '") +
                         plant[harm->modes[i].first].name + "' in " + name(i);
      }
      result.reason += ", a combination that the model excludes";
      return result;
    }
    result.why.obstacle = Reason::Obstacle::forbidden;
    result.why.aim = harm->modes.back().second;
    const auto& transitions = plant[c].transitions;
    for (std::size_t t = 0; t < transitions.size() && !result.why.step; ++t) {
      if (transitions[t].from == harm->modes.front().second && transitions[t].to == harm->modes.back().second &&
          !plant[c].is_fault(transitions[t]))
        result.why.step = TransitionOf{c, automata::TransitionId(t)};
    }
    result.reason = "the goal needs the irreversible step of '" + plant[c].name + "' from " + name(0) + " to " +
                    name(1) + ", but does not name the mode to which this step leads";
    return result;
  }

  automata::PlantStep& step_;
  const NominalGraph& graph_;
  Strategist& strategist_;
  const Modes& modes_;
  const StrategyPosition& position_;
};

}  // namespace

std::optional<Reconfiguration> strategy_answer(automata::PlantStep& step, const NominalGraph& graph,
                                               Strategist& strategist, const Modes& modes,
                                               const StrategyPosition& position) {
  return Answering(step, graph, strategist, modes, position).run();
}

}  // namespace rmpl::runtime
