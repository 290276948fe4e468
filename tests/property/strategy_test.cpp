// Strategies beside the game solved by looking at every node, on plants as engineers write them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/game/rewards.hpp"
#include "runtime/reasoning/game/strategist.hpp"
#include "runtime/reasoning/game/ways.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"
#include "tests/property/engineered.hpp"
#include "tests/reference/game.hpp"
#include "tests/reference/game_ages.hpp"
#include "tests/reference/game_pursuit.hpp"
#include "tests/reference/game_text.hpp"

namespace rmpl::property {
namespace {

std::vector<automata::ComponentId> all_components(const automata::Plant& plant) {
  std::vector<automata::ComponentId> result;
  for (std::size_t c = 0; c < plant.components.size(); ++c) result.emplace_back(c);
  return result;
}

runtime::Cost known(const reference::GameCost& cost) {
  const auto whole = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  return {.irreversible = whole(cost.irreversible),
          .lost = whole(cost.lost),
          .worth = std::llround(cost.worth * 1e6),
          .unbounded = whole(cost.time.unbounded),
          .time = cost.time.ticks,
          .moves = whole(cost.moves),
          .disturbed = whole(cost.disturbed),
          .commands = whole(cost.commands),
          .waits = whole(cost.waits),
          .reward = std::llround(cost.reward * 1e6)};
}

/// The game of all components.
struct Played {
  automata::PlantStep step;
  runtime::NominalGraph graph;
  runtime::GameGoal goal;
  runtime::Arena arena;
  runtime::Game game;

  Played(const Engineered& drawn, runtime::Game::Memory memory,
         automata::Ticks cycle = automata::Ticks{automata::Ticks::per_second},
         std::optional<std::size_t> alike = std::nullopt)
      : step(drawn.plant),
        graph(drawn.plant),
        goal(drawn.goal, step, graph),
        arena(step, graph, goal, all_parts(goal), all_components(drawn.plant), drawn.start,
              [](std::size_t) { return true; }),
        game(arena, memory, cycle, {std::size_t{1} << 14, std::size_t{1} << 20, alike}, drawn.start) {}

  static std::vector<std::size_t> all_parts(const runtime::GameGoal& goal) {
    std::vector<std::size_t> parts(goal.parts());
    std::iota(parts.begin(), parts.end(), std::size_t{0});
    return parts;
  }
};

void compare(runtime::Game::Memory memory, std::size_t most_parts,
             automata::Ticks cycle = automata::Ticks{automata::Ticks::per_second}) {
  const Engineered drawn = *engineered(2, most_parts);
  RC_LOG() << rc::toString(drawn) << std::endl;
  reference::GameStep twin_step(drawn.plant);
  reference::ModeArena modes(twin_step, automata::Ticks::per_second);
  reference::AgedArena ages(twin_step, cycle.count);
  reference::Arena& twin_arena = memory == runtime::Game::Memory::modes ? static_cast<reference::Arena&>(modes) : ages;
  reference::Board board(twin_arena, drawn.goal, {}, 3000);
  try {
    const reference::Node start = twin_arena.start(drawn.start);
    const reference::Game twin(board, start);
    Played played(drawn, memory, cycle);
    const runtime::Game& game = played.game;
    RC_PRE(!game.too_large());
    const runtime::Solution solution(game, 0);
    const reference::Solution& expected = twin.solution();
    RC_LOG() << to_text(expected.level) << ": " << to_text(expected.cost) << std::endl << whole(board, twin, start);
    const runtime::GameDecision& found = solution.at(0);
    RC_TAG(to_text(expected.level));
    RC_ASSERT(static_cast<int>(found.rank) == static_cast<int>(expected.level.rank));
    RC_ASSERT(found.rank == runtime::Rank::none || found.lasts == expected.level.lasts);
    RC_ASSERT(solution.kept()[0] == twin.kept().contains(start));
    if (found.rank != runtime::Rank::none) RC_ASSERT((found.cost == known(expected.cost)));
  } catch (const reference::GameTooLarge&) {
    RC_DISCARD();
  }
}

/// Rank, whether the goal lasts, and every entry of the cost.
RC_GTEST_PROP(Strategy, AgreesWithTheTwinOverModes, ()) { compare(runtime::Game::Memory::modes, 5); }
RC_GTEST_PROP(Strategy, AgreesWithTheTwinOverAges, ()) { compare(runtime::Game::Memory::ages, 4); }
RC_GTEST_PROP(Strategy, AgreesWithTheTwinInDenseTime, ()) {
  compare(runtime::Game::Memory::ages, 4, automata::Ticks{0});
}

/// A strategy that looks at few ages of the same modes is no surer than the best of all ages.
RC_GTEST_PROP(Strategy, OfFewAgesPromisesNoMore, ()) {
  const Engineered drawn = *engineered(2, 4);
  const automata::Ticks cycle{*rc::gen::element<std::int64_t>(0, automata::Ticks::per_second)};
  RC_LOG() << rc::toString(drawn) << std::endl;
  Played all(drawn, runtime::Game::Memory::ages, cycle);
  Played few(drawn, runtime::Game::Memory::ages, cycle, *rc::gen::inRange<std::size_t>(1, 8));
  RC_PRE(!all.game.too_large() && !few.game.too_large());
  const runtime::GameDecision best = runtime::Solution(all.game, 0).at(0);
  const runtime::GameDecision found = runtime::Solution(few.game, 0).at(0);
  const int least = runtime::level_number({best.rank, best.lasts});
  const int own = runtime::level_number({found.rank, found.lasts});
  RC_TAG(few.game.nodes().size() < all.game.nodes().size() ? "fewer" : "as many",
         own == least ? "as sure" : "less sure");
  RC_ASSERT(own >= least);
}

/// Whether a reward is pursued where the goal is kept, which, and what that costs.
RC_GTEST_PROP(Strategy, PursuesTheRewardsOfTheTwin, ()) {
  const Engineered drawn = *engineered(2, 5);
  RC_LOG() << rc::toString(drawn) << std::endl;
  reference::GameStep twin_step(drawn.plant);
  reference::ModeArena twin_arena(twin_step, automata::Ticks::per_second);
  reference::Board board(twin_arena, drawn.goal, {}, 3000);
  try {
    const reference::Node start = twin_arena.start(drawn.start);
    const reference::Game twin(board, start);
    Played played(drawn, runtime::Game::Memory::modes);
    RC_PRE(!played.game.too_large());
    runtime::GameRewards rewards(played.game);
    std::size_t pursued = 0;
    for (std::uint32_t n = 0; n < played.game.nodes().size() && n < 20; ++n) {
      const reference::Node node = twin_arena.start(played.game.position(n).modes);
      if (!twin.kept().contains(node)) continue;
      const reference::Pursuit expected(board, twin.kept(), node);
      const auto found = rewards.from(n);
      RC_LOG() << "node " << n << ": " << expected.reward().value_or(-1) << ", resting " << expected.idle()
               << std::endl;
      RC_ASSERT(found.has_value() == expected.reward().has_value());
      if (!found) continue;
      ++pursued;
      RC_ASSERT(found->reward == std::llround(*expected.reward() * 1e6));
      RC_ASSERT(found->rest == std::llround(expected.idle() * 1e6));
      RC_ASSERT((found->cost == known(expected.cost())));
    }
    RC_TAG(pursued > 0);
  } catch (const reference::GameTooLarge&) {
    RC_DISCARD();
  }
}

/// Groups that are solved apart have together no worse a rank than the goal as a whole: what has nothing to do with
/// them interrupts no wait of theirs.
RC_GTEST_PROP(Strategy, GroupsHaveNoWorseARankThanTheWhole, ()) {
  const Engineered drawn = *engineered(2, 5);
  RC_LOG() << rc::toString(drawn) << std::endl;
  reference::GameStep twin_step(drawn.plant);
  // Strategies without a cycle are those of ever shorter ones.
  reference::ModeArena arena(twin_step, 1);
  reference::Board board(arena, drawn.goal, {}, 3000);
  try {
    const reference::Node start = arena.start(drawn.start);
    const reference::Game twin(board, start);
    automata::PlantStep step(drawn.plant);
    const runtime::NominalGraph graph(drawn.plant);
    runtime::Strategist strategist(step, graph, drawn.goal);
    const runtime::Strategist::Answer found = strategist.from(drawn.start);
    RC_PRE(found.solved);
    const reference::Level expected = twin.solution().level;
    RC_LOG() << to_text(expected) << std::endl << whole(board, twin, start);
    RC_TAG(to_text(expected), found.groups.size());
    RC_ASSERT(static_cast<int>(found.rank) <= static_cast<int>(expected.rank));
    RC_ASSERT((found.rank == runtime::Rank::none) == (expected.rank == reference::Rank::none));
    if (static_cast<int>(found.rank) == static_cast<int>(expected.rank) && found.rank != runtime::Rank::none)
      RC_ASSERT(found.lasts || !expected.lasts);
  } catch (const reference::GameTooLarge&) {
    RC_DISCARD();
  }
}

}  // namespace
}  // namespace rmpl::property
