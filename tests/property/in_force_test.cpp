// The executive with its strategies in force, flown cycle by cycle against every choice of nature.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "automata/assignment_text.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/game/strategist.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/strategy_answer.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/engineered.hpp"
#include "tests/reference/game.hpp"
#include "tests/reference/game_ages.hpp"
#include "tests/reference/game_text.hpp"
#include "tests/reference/game_ticks.hpp"

namespace rmpl::property {
namespace {

using reference::Node;
using reference::Rank;

constexpr std::int64_t second = automata::Ticks::per_second;
constexpr std::size_t most_places = 20'000;

/// What an executive knows besides modes.
enum class Knows {
  modes,   ///< nothing: bounds do not count
  bounds,  ///< bounds, but ages are forgotten in each cycle
  ages     ///< the ages of the node in force
};

/// All that the executive and nature come to together. Throws `GameTooLarge`.
class ClosedLoop {
 public:
  ClosedLoop(const Engineered& drawn, reference::TickArena& ticks, Knows knows)
      : drawn_(drawn),
        ticks_(ticks),
        knows_(knows),
        step_(drawn.plant),
        graph_(drawn.plant),
        strategist_(step_, graph_, drawn.goal,
                    knows == Knows::modes ? std::nullopt : std::optional(automata::Ticks{second})),
        irreversible_(ticks.step(), drawn.goal, {}) {
    number({ticks_.start(drawn.start), {}});
    for (std::size_t p = 0; p < places_.size(); ++p) explore(p);
  }

  /// The greatest number of cycles after which the goal holds for ever; nothing where it may be lost again and again,
  /// or never be reached.
  std::optional<std::int64_t> until_it_lasts() {
    return longest([&](std::size_t p) { return may_fail(p); });
  }
  /// The greatest number of cycles after which the goal has held once.
  std::optional<std::int64_t> until_it_holds() {
    return longest([&](std::size_t p) { return !holds(p); });
  }
  /// The model excludes all that could come somewhere: what a strategy counts on then is excluded, too.
  [[nodiscard]] bool is_stuck() const {
    return std::any_of(next_.begin(), next_.end(), [](const auto& next) { return next.empty(); });
  }
  [[nodiscard]] bool always_holds() const {
    for (std::size_t p = 0; p < places_.size(); ++p)
      if (!holds(p)) return false;
    return true;
  }
  /// The irreversible steps that are taken and that the goal does not license.
  [[nodiscard]] const reference::Harms& harms() const { return harms_; }

 private:
  using Place = std::pair<Node, runtime::StrategyPosition>;

  std::size_t number(const Place& place) {
    const auto [at, fresh] = numbers_.try_emplace(place, places_.size());
    if (fresh) places_.push_back(place);
    if (places_.size() > most_places) throw reference::GameTooLarge();
    return at->second;
  }

  void explore(std::size_t p) {
    const Place place = places_[p];
    const automata::Modes modes = ticks_.modes(place.first);
    const auto found = strategy_answer(step_, graph_, strategist_, modes, place.second);
    if (!found) throw reference::GameTooLarge();
    const runtime::Reconfiguration& answer = *found;
    const auto& actions = ticks_.step().actions();
    const auto action = std::find(actions.begin(), actions.end(), answer.action) - actions.begin();
    const auto& variables = drawn_.plant.variables;
    RC_LOG() << p << (place.second.is_empty() ? ": " : " (in force): ")
             << to_text(variables, automata::assignments_of(drawn_.plant, modes)) << "; "
             << to_text(variables, automata::commanded(drawn_.plant, answer.action)) << std::endl;
    next_.resize(places_.size());
    const auto turn = ticks_.turn(place.first, static_cast<reference::GameStep::Action>(action));
    RC_ASSERT(turn.has_value());
    std::set<std::size_t> next;
    for (const reference::Result& result : turn->results) {
      const automata::Modes& then = ticks_.modes(result.to);
      for (std::size_t c = 0; c < modes.size(); ++c) {
        if (then[c] != modes[c] && irreversible_.is_irreversible(c, modes[c], then[c]) &&
            !irreversible_.is_licensed(c, then[c]))
          harms_.insert({{{c, modes[c]}}, then[c]});
      }
      next.insert(
          number({result.to, knows_ == Knows::ages ? position_after(answer, then) : runtime::StrategyPosition()}));
    }
    next_.resize(places_.size());
    next_[p].assign(next.begin(), next.end());
    RC_LOG() << "    to " << rc::toString(next_[p]) << std::endl;
  }

  [[nodiscard]] bool holds(std::size_t p) const {
    return ticks_.step().entails(ticks_.modes(places_[p].first), drawn_.goal);
  }
  /// Whether the goal does not hold there, or may not later.
  bool may_fail(std::size_t p) {
    if (failing_.empty()) {
      failing_.resize(places_.size());
      for (std::size_t q = 0; q < places_.size(); ++q) failing_[q] = !holds(q);
      for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t q = 0; q < places_.size(); ++q) {
          if (failing_[q]) continue;
          failing_[q] = std::any_of(next_[q].begin(), next_[q].end(), [&](std::size_t n) { return failing_[n]; });
          changed = changed || failing_[q];
        }
      }
    }
    return failing_[p];
  }

  /// Of the paths through such places from the start; nothing where one is without end.
  template <class Open>
  std::optional<std::int64_t> longest(const Open& open) {
    std::map<std::size_t, std::optional<std::int64_t>> known;
    return from(0, open, known);
  }
  template <class Open>
  std::optional<std::int64_t> from(std::size_t p, const Open& open,
                                   std::map<std::size_t, std::optional<std::int64_t>>& known) {
    if (!open(p)) return 0;
    const auto [at, fresh] = known.try_emplace(p, std::nullopt);
    if (!fresh) return at->second;
    std::int64_t most = 1;
    if (next_[p].empty()) return std::nullopt;
    for (const std::size_t n : next_[p]) {
      const auto later = from(n, open, known);
      if (!later) return std::nullopt;
      most = std::max(most, *later + 1);
    }
    return known[p] = most;
  }

  const Engineered& drawn_;
  reference::TickArena& ticks_;
  Knows knows_;
  automata::PlantStep step_;
  runtime::NominalGraph graph_;
  runtime::Strategist strategist_;
  reference::Irreversible irreversible_;
  std::map<Place, std::size_t> numbers_;
  std::vector<Place> places_;
  std::vector<std::vector<std::size_t>> next_;
  std::vector<bool> failing_;
  reference::Harms harms_;
};

bool has_rewards(const automata::Plant& plant) {
  return std::any_of(plant.components.begin(), plant.components.end(), [](const automata::Component& component) {
    return std::any_of(component.modes.begin(), component.modes.end(), [](const auto& m) { return m.reward != 0; });
  });
}

/// What strategies promise, with the time of the slowest group where that is a bound.
struct Promise {
  Rank rank;
  bool lasts;
  std::optional<std::int64_t> time;  ///< ticks
};

Promise promise_of(const Engineered& drawn) {
  automata::PlantStep step(drawn.plant);
  const runtime::NominalGraph graph(drawn.plant);
  runtime::Strategist strategist(step, graph, drawn.goal, automata::Ticks{second});
  const runtime::Strategist::Answer answer = strategist.from(drawn.start);
  const bool sure = answer.rank == runtime::Rank::sure;
  Promise promise{sure ? Rank::sure : Rank::none, answer.lasts, std::nullopt};
  if (!sure || has_rewards(drawn.plant)) return promise;
  // Groups that do not last have held apart in time; together they hold later.
  if (!answer.lasts && answer.groups.size() > 1) return promise;
  std::int64_t longest = 0;
  for (const runtime::SolvedGame& group : answer.groups) {
    // A run on which less is lost may take longer. A command over modes alone takes no time.
    const runtime::Cost& cost = group.decision().cost;
    if (cost.irreversible > 0 || cost.lost > 0 || cost.unbounded > 0) return promise;
    const bool aged = group.game->memory() == runtime::Game::Memory::ages;
    longest = std::max(longest, cost.time + (aged ? 0 : cost.moves * second));
  }
  promise.time = longest;
  return promise;
}

/// What is sure is had in time, what lasts is kept, and what is kept is never lost, by a flight from where nothing is
/// known of ages. Nothing irreversible is taken that the goal does not license and that could not come anyway. What the
/// twin has surely is promised: but where a command of one group ends a wait of another and lets it think again.
RC_GTEST_PROP(StrategyInForce, HasWhatTheTwinHas, ()) {
  const Engineered drawn = *engineered(2, 4);
  RC_LOG() << rc::toString(drawn) << std::endl;
  reference::GameStep step(drawn.plant);
  reference::AgedArena aged(step, second);
  reference::TickArena ticks(step, second);
  reference::Board board(aged, drawn.goal, {}, 3000);
  try {
    const Node start = aged.start(drawn.start);
    const reference::Game twin(board, start);
    const reference::Solution& expected = twin.solution();
    RC_LOG() << to_text(expected.level) << ": " << to_text(expected.cost) << std::endl << whole(board, twin, start);
    ClosedLoop loop(drawn, ticks, Knows::ages);
    RC_PRE(!loop.is_stuck());
    const reference::Harms& may = board.harms(start);
    RC_ASSERT(std::includes(may.begin(), may.end(), loop.harms().begin(), loop.harms().end()));
    const bool kept = twin.kept().contains(start);
    const Promise promise = promise_of(drawn);
    const bool sure = expected.level.rank == Rank::sure;
    RC_TAG(kept                         ? "kept"
           : !sure                      ? "not sure"
           : promise.rank != Rank::sure ? "sure together alone"
           : expected.level.lasts       ? "sure, lasts"
                                        : "sure");
    if (kept) RC_ASSERT(loop.always_holds());
    if (kept || promise.rank != Rank::sure) return;
    const auto cycles = promise.lasts ? loop.until_it_lasts() : loop.until_it_holds();
    RC_ASSERT(cycles.has_value());
    RC_ASSERT(!promise.time || *cycles * second <= *promise.time);
  } catch (const reference::GameTooLarge&) {
    RC_DISCARD();
  }
}

/// Beside the best that an executive could do which knew every age. What is asked of plants without rewards whose goal
/// can surely be had.
std::string beside_the_best(const Engineered& drawn, reference::TickArena& ticks, const reference::Solution& best,
                            Knows knows) {
  ClosedLoop loop(drawn, ticks, knows);
  if (loop.is_stuck()) return "stuck";  // resting may bring what the model excludes
  const auto cycles = best.level.lasts ? loop.until_it_lasts() : loop.until_it_holds();
  if (!cycles) return "never";
  return *cycles * second <= best.cost.time.ticks ? "as fast as can be" : "slower";
}

/// Of plants whose goal can surely be had, how fast it is had at worst: the distribution is printed.
RC_GTEST_PROP(StrategyInForce, IsBesideTheBest, ()) {
  Engineered drawn = *engineered(2, 4);
  for (automata::Component& component : drawn.plant.components)
    for (automata::Mode& mode : component.modes) mode.reward = 0;
  RC_LOG() << rc::toString(drawn) << std::endl;
  reference::GameStep step(drawn.plant);
  reference::TickArena ticks(step, second);
  reference::Board board(ticks, drawn.goal, {}, 6000);
  try {
    const reference::Game game(board, ticks.start(drawn.start));
    const reference::Solution& best = game.solution();
    RC_PRE(best.level.rank == Rank::sure && !game.kept().contains(ticks.start(drawn.start)));
    RC_LOG() << to_text(best.level) << ": " << to_text(best.cost) << std::endl;
    const std::string modes = beside_the_best(drawn, ticks, best, Knows::modes);
    const std::string bounds = beside_the_best(drawn, ticks, best, Knows::bounds);
    const std::string ages = beside_the_best(drawn, ticks, best, Knows::ages);
    RC_ASSERT(promise_of(drawn).rank != Rank::sure || ages != "never");
    RC_TAG(modes + " by modes, " + bounds + " by bounds, " + ages + " in force");
  } catch (const reference::GameTooLarge&) {
    RC_DISCARD();
  }
}

}  // namespace
}  // namespace rmpl::property
