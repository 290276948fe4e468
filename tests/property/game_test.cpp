// The three readings of the game of plans against each other, on plants as engineers write them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "tests/property/draw.hpp"
#include "tests/property/engineered.hpp"
#include "tests/reference/game.hpp"
#include "tests/reference/game_ages.hpp"
#include "tests/reference/game_text.hpp"
#include "tests/reference/game_ticks.hpp"

namespace rmpl::property {
namespace {

using reference::Rank;

constexpr std::int64_t second = automata::Ticks::per_second;

auto before_time(const reference::GameCost& cost) { return std::tuple(cost.irreversible, cost.lost, cost.worth); }

void take_away_rewards(automata::Plant& plant) {
  for (automata::Component& component : plant.components)
    for (automata::Mode& mode : component.modes) mode.reward = 0;
}

/// A strategy over intervals of ages, flown cycle by cycle against every choice of nature.
class Flights {
 public:
  Flights(reference::AgedArena& arena, const reference::Game& game)
      : arena_(arena), game_(game), ticks_(arena.step(), second) {}

  reference::TickArena& ticks() { return ticks_; }

  /// The greatest number of cycles until the target is reached. Throws where nature does what no edge of the strategy
  /// shows, or where the target is never reached.
  std::int64_t longest(reference::Node node, reference::Node truth) {
    const auto& target = game_.solution().level.lasts ? game_.kept() : game_.holding();
    if (target.contains(node)) {
      if (game_.kept().contains(node)) stay(node, truth);
      return 0;
    }
    const auto [at, fresh] = longest_.try_emplace({node, truth}, -1);
    if (!fresh && at->second < 0) throw std::runtime_error("it goes in a circle");
    if (!fresh) return at->second;
    std::int64_t most = 0;
    for (const auto& [next, real] : after(node, truth, false)) most = std::max(most, longest(next, real) + 1);
    return longest_[{node, truth}] = most;
  }

 private:
  using Place = std::pair<reference::Node, reference::Node>;

  /// The goal is kept for ever.
  void stay(reference::Node node, reference::Node truth) {
    std::vector<Place> open{{node, truth}};
    while (!open.empty()) {
      const Place place = open.back();
      open.pop_back();
      if (!kept_.insert(place).second) continue;
      if (!game_.kept().contains(place.first)) throw std::runtime_error("it is not kept");
      for (const Place& next : after(place.first, place.second, true)) open.push_back(next);
    }
  }

  std::vector<Place> after(reference::Node node, reference::Node truth, bool reached) {
    const reference::Option& option = *game_.solution().strategy.at({node, reached}).option;
    std::vector<Place> result;
    const auto turn = ticks_.turn(truth, option.action);
    if (!turn || turn->dead) throw std::runtime_error("the model has no way to go on");
    for (const reference::Result& real : turn->results) {
      if (option.waits && ticks_.modes(real.to) == ticks_.modes(truth)) {
        result.emplace_back(node, real.to);
        continue;
      }
      const auto way = std::find_if(option.ways.begin(), option.ways.end(),
                                    [&](const reference::Option::Way& w) { return shows(w.to, real.to); });
      if (way == option.ways.end()) throw std::runtime_error("no edge shows it");
      result.emplace_back(way->to, real.to);
    }
    return result;
  }
  bool shows(reference::Node node, reference::Node truth) {
    if (arena_.modes(node) != ticks_.modes(truth)) return false;
    for (std::size_t c = 0; c < arena_.ages(node).size(); ++c) {
      const reference::Age age = arena_.ages(node)[c];
      if (ticks_.ages(truth)[c] < age.least || ticks_.ages(truth)[c] > age.most) return false;
    }
    return true;
  }

  reference::AgedArena& arena_;
  const reference::Game& game_;
  reference::TickArena ticks_;
  std::map<Place, std::int64_t> longest_;
  std::set<Place> kept_;
};

/// Who follows a sure strategy comes to its target within the time that it is charged, and keeps what lasts.
RC_GTEST_PROP(Game, SureStrategiesArriveInTime, ()) {
  Engineered drawn = *engineered(2, 4);
  const bool rewards = chance(50);
  if (!rewards) take_away_rewards(drawn.plant);
  RC_LOG() << rc::toString(drawn) << std::endl;
  reference::GameStep step(drawn.plant);
  reference::AgedArena aged(step, second);
  reference::Board board(aged, drawn.goal, {}, 4000);
  try {
    const reference::Node start = aged.fresh(drawn.start);
    const reference::Game game(board, start);
    const reference::Solution& known = game.solution();
    RC_TAG(known.level.rank == Rank::sure ? "sure" : "not sure");
    if (known.level.rank != Rank::sure) return;
    RC_LOG() << to_text(known.level) << ": " << to_text(known.cost) << std::endl << whole(board, game, start);
    Flights flights(aged, game);
    const std::int64_t longest = flights.longest(start, flights.ticks().start(drawn.start)) * second;
    // A run on which less is lost, or more gained, than on the worst one may take longer.
    const bool bounds = known.cost.irreversible == 0 && known.cost.lost == 0 && !rewards;
    RC_ASSERT(!bounds || longest <= known.cost.time.ticks);
  } catch (const reference::GameTooLarge&) {
    RC_DISCARD();
  }
}

/// Who knows the bounds, and no more, has no more than who knows every age.
RC_GTEST_PROP(Game, IntervalsOfAgesPromiseNoMoreThanTicksHold, ()) {
  Engineered drawn = *engineered(2, 4);
  take_away_rewards(drawn.plant);
  RC_LOG() << rc::toString(drawn) << std::endl;
  reference::GameStep step(drawn.plant);
  reference::AgedArena aged(step, second);
  reference::TickArena ticks(step, second);
  reference::Board coarse(aged, drawn.goal, {}, 4000);
  reference::Board fine(ticks, drawn.goal, {}, 20000);
  try {
    const reference::Node start = aged.fresh(drawn.start);
    const reference::Game game(coarse, start);
    const reference::Solution& known = game.solution();
    RC_TAG(known.level.rank == Rank::sure ? "sure" : "not sure");
    if (known.level.rank != Rank::sure) return;
    RC_LOG() << to_text(known.level) << ": " << to_text(known.cost) << std::endl << whole(coarse, game, start);
    const reference::Game best(fine, ticks.start(drawn.start));
    const reference::Solution& true_one = best.solution();
    RC_LOG() << to_text(true_one.level) << ": " << to_text(true_one.cost) << std::endl;
    RC_ASSERT(true_one.level.rank == Rank::sure);
    RC_ASSERT(!known.level.lasts || true_one.level.lasts);
    // What is lost at the end depends on ages that intervals do not tell.
    const bool alike = known.level == true_one.level && before_time(known.cost) == before_time(true_one.cost);
    if (alike) RC_ASSERT(true_one.cost.time <= known.cost.time);
  } catch (const reference::GameTooLarge&) {
    RC_DISCARD();
  }
}

}  // namespace
}  // namespace rmpl::property
