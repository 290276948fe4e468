// Islands that exclude modes, and games that are known to be too large.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/plant_games.hpp"

#include "automata/store/totality.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Modes;

namespace {

constexpr std::size_t most_keys = 1024;  // starts of large games, and sets of components; beyond it all are forgotten

}  // namespace

PlantGames::PlantGames(automata::PlantStep& step, const NominalGraph& graph)
    : step_(step), graph_(graph), excludes_(step.locality().islands().size()) {}

bool PlantGames::excludes(std::size_t island) {
  auto& known = excludes_[island];
  if (!known) known = !automata::is_total(step_.plant(), step_.locality().islands()[island]);
  return *known;
}

PlantGames::Start PlantGames::start_of(const Arena& arena, const Modes& modes) {
  Start start{arena.components(), arena.context(), {}};
  start.modes.reserve(start.components.size() + start.context.size());
  for (const auto* const some : {&start.components, &start.context}) {
    for (const ComponentId c : *some) start.modes.push_back(modes[c.index()]);
  }
  return start;
}

bool PlantGames::is_large(const Arena& arena, const Modes& modes) const {
  return !large_.empty() && large_.contains(start_of(arena, modes));
}

void PlantGames::note(const Game& game, const Modes& modes) {
  if (!game.beyond_limits()) return;
  if (large_.size() >= most_keys) large_.clear();
  large_.insert(start_of(game.arena(), modes));
}

std::vector<PlayedGame>& PlantGames::games_without_goal(const std::vector<ComponentId>& components) {
  if (games_without_goal_.size() >= most_keys && !games_without_goal_.contains(components)) games_without_goal_.clear();
  return games_without_goal_[components];
}

const GameGoal& PlantGames::no_goal() {
  if (!no_goal_) no_goal_.emplace(automata::constant(true), step_, graph_);
  return *no_goal_;
}

}  // namespace rmpl::runtime
