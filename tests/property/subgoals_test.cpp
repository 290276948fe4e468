// Goals of single components beside the game of all components, on plants as engineers write them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>
#include <vector>

#include "runtime/reasoning/game/solve.hpp"
#include "runtime/reasoning/reconfigure/subgoals.hpp"
#include "tests/property/engineered.hpp"

namespace rmpl::property {
namespace {

using automata::Modes;
using runtime::Reconfiguration;

/// What the game of all components permits in these modes.
void expect_permitted(const runtime::Game& game, const Modes& modes, const Reconfiguration& answer) {
  const auto node = game.find(modes);
  RC_ASSERT(node.has_value());
  const runtime::Game::Node& at = game.nodes()[*node];
  for (std::uint32_t e = at.first; e < at.first + at.count; ++e) {
    const runtime::Game::Edge& edge = game.edges()[e];
    if (game.arena().action(edge.action) == answer.action) RC_ASSERT(edge.permitted);
  }
}

/// Step by step as expected: no step is forbidden, and the goal is reached only where some strategy reaches it.
RC_GTEST_PROP(Subgoals, DoNoHarmAndReachWhatCanBeReached, ()) {
  const Engineered drawn = *engineered(2, 3);
  RC_LOG() << rc::toString(drawn) << std::endl;
  automata::PlantStep step(drawn.plant);
  const runtime::NominalGraph graph(drawn.plant);
  const runtime::GameGoal game_goal(drawn.goal, step, graph);
  std::vector<std::size_t> parts(game_goal.parts());
  std::iota(parts.begin(), parts.end(), std::size_t{0});
  runtime::Arena arena(step, graph, game_goal, parts, graph.components(), drawn.start,
                       [](std::size_t) { return true; });
  const runtime::Game game(arena, runtime::Game::Memory::modes, automata::Ticks{0},
                           {std::size_t{1} << 14, std::size_t{1} << 20}, drawn.start);
  if (game.too_large()) return;
  const runtime::Rank rank = runtime::Solution(game, *game.find(drawn.start)).at(*game.find(drawn.start)).rank;

  const runtime::Goal goal(drawn.goal, drawn.plant, step.theory());
  runtime::Subgoals subgoals(step, graph);
  runtime::GoalInterpreter interpreter(step, graph);
  Modes modes = drawn.start;
  bool reached = interpreter.entailed(modes, goal);
  bool none = false;
  for (int steps = 0; steps < 64 && !reached && !none; ++steps) {
    const Reconfiguration answer = subgoals.next(modes, goal);
    none = answer.outcome == Reconfiguration::Outcome::no_plan || !answer.expected;
    if (none) break;
    expect_permitted(game, modes, answer);
    modes = *answer.expected;
    reached = interpreter.entailed(modes, goal);
  }
  if (reached) RC_ASSERT(rank != runtime::Rank::none);
  RC_TAG(rank == runtime::Rank::none ? "no strategy" : reached ? "reached" : none ? "no plan" : "not in 64 steps");
}

}  // namespace
}  // namespace rmpl::property
