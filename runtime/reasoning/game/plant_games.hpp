// What the games on one plant have in common, whatever their goals.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/game/game.hpp"
#include "runtime/reasoning/game/game_goal.hpp"
#include "runtime/reasoning/game/played_game.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"

namespace rmpl::runtime {

/// Shared by the strategists of one plant, so that a new goal does not ask again. Keeps references.
class PlantGames {
 public:
  PlantGames(automata::PlantStep& step, const NominalGraph& graph);

  /// Whether the constraints of an island may exclude modes or commands.
  bool excludes(std::size_t island);
  /// Whether a game of all actions over modes was too large before, with these components from these modes: what can be
  /// done does not depend on the goal.
  [[nodiscard]] bool is_large(const Arena& arena, const automata::Modes& modes) const;
  /// A game of all actions over modes was played from these modes.
  void note(const Game& game, const automata::Modes& modes);
  /// The goal that asks for nothing.
  const GameGoal& no_goal();
  /// Games over modes of components that a goal leaves alone are those of `no_goal()`, by their components.
  using Games = std::map<std::vector<automata::ComponentId>, std::vector<PlayedGame>>;
  Games& games_without_goal() { return games_without_goal_; }
  /// Of these components. Beyond a number of such sets the games of all are forgotten.
  std::vector<PlayedGame>& games_without_goal(const std::vector<automata::ComponentId>& components);

 private:
  /// Components of the arena, those on which it rests, the modes of both.
  struct Start {
    std::vector<automata::ComponentId> components, context;
    automata::Modes modes;
    auto operator<=>(const Start&) const = default;
  };
  [[nodiscard]] static Start start_of(const Arena& arena, const automata::Modes& modes);

  automata::PlantStep& step_;
  const NominalGraph& graph_;
  std::vector<std::optional<bool>> excludes_;  ///< by island, once asked
  std::set<Start> large_;
  std::optional<GameGoal> no_goal_;  ///< once asked for
  Games games_without_goal_;
};

}  // namespace rmpl::runtime
