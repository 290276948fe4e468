// Groups of a goal: solved apart for as long as their strategies do not touch each other.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/strategist.hpp"

#include <algorithm>
#include <utility>

#include "runtime/reasoning/game/sorted_sets.hpp"
#include "runtime/reasoning/nominal/idling.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::Modes;

namespace {

constexpr std::size_t most_game_nodes = std::size_t{1} << 14;
constexpr std::size_t few_outcomes = std::size_t{1} << 13;        // beyond it only useful actions are looked at
constexpr std::size_t most_game_outcomes = std::size_t{1} << 21;  // solved in about two seconds, in 500 MiB
constexpr std::size_t many_outcomes = std::size_t{1} << 16;       // beyond it a game is large
constexpr std::size_t most_remembered = 3 * most_game_outcomes;   // beyond it large games are forgotten
constexpr std::size_t most_combinations = std::size_t{1} << 16;   // of modes; beyond it no game is begun
constexpr std::size_t some_combinations = std::size_t{1} << 8;    // beyond it a game takes long
constexpr std::size_t few_combinations = std::size_t{1} << 6;     // the same of a least group
constexpr std::size_t games_remembered = 16;                      // of one group, in different contexts
constexpr std::size_t solutions_remembered = 64;                  // of one game

}  // namespace

Strategist::Strategist(automata::PlantStep& step, const NominalGraph& graph, const automata::Formula& goal,
                       std::optional<automata::Ticks> cycle, Relevant relevant, Least least,
                       std::shared_ptr<PlantGames> common)
    : step_(step),
      graph_(graph),
      cycle_(cycle),
      counts_ages_(cycle.has_value()),
      holds_(relevant == Relevant::read),
      least_(least),
      goal_(goal, step, graph),
      goal_text_(to_text(goal, step.plant().variables)),
      common_(common ? std::move(common) : std::make_shared<PlantGames>(step, graph)) {
  for (std::size_t p = 0; p < goal_.parts(); ++p) {
    auto components = relevant == Relevant::read ? goal_.read_by(p) : graph.upstream(goal_.read_by(p));
    std::sort(components.begin(), components.end());
    relevant_.push_back(std::move(components));
  }
}

/// Whether the components outside are in the modes that the arena rests on.
bool Strategist::in_context(const Arena& arena, const Modes& modes) {
  const auto& context = arena.context();
  return std::all_of(context.begin(), context.end(),
                     [&](ComponentId c) { return arena.start_modes()[c.index()] == modes[c.index()]; });
}

/// Forgets the large games of all groups where they have become many.
void Strategist::forget_large() {
  const auto for_each = [&](const auto& visit) {
    for (auto& [key, games] : games_) visit(games);
    for (auto& [components, games] : common_->games_without_goal()) visit(games);
  };
  std::size_t outcomes = 0;
  for_each([&](const std::vector<PlayedGame>& games) {
    for (const PlayedGame& played : games) outcomes += played.game->outcomes().size();
  });
  if (outcomes <= most_remembered) return;
  for_each([](std::vector<PlayedGame>& games) {
    std::erase_if(games, [](const PlayedGame& played) { return played.game->outcomes().size() > many_outcomes; });
  });
}

/// Whether the goal asks for nothing in the group, and licenses nothing there: it speaks of none of its components.
bool Strategist::is_left_alone(const Group& group) const {
  const auto& components = group.played();
  return group.parts.empty() &&
         std::none_of(components.begin(), components.end(), [&](ComponentId c) { return goal_.reads(c); });
}

/// The components of the group, with all actions or with useful ones only.
std::shared_ptr<Arena> Strategist::arena_of(const Group& group, const Modes& modes, bool all_actions) {
  const GameGoal& goal = is_left_alone(group) ? common_->no_goal() : goal_;
  auto arena = std::make_shared<Arena>(step_, graph_, goal, group.parts, group.played(), modes,
                                       [this](std::size_t island) { return common_->excludes(island); });
  if (!all_actions) arena->restrict_to_useful();
  return arena;
}

/// With all actions; where that is too large and `useful` is asked for, with useful ones.
PlayedGame& Strategist::game_of(const Group& group, const Modes& modes, bool useful) {
  auto& games =
      is_left_alone(group) ? common_->games_without_goal(group.played()) : games_[{group.parts, group.played()}];
  const auto play = [&](PlayedGame& played, bool best) {
    played.arena = arena_of(group, modes, best);
    Game::Limits limits{most_game_nodes, best ? few_outcomes : most_game_outcomes};
    if (best && common_->is_large(*played.arena, modes)) limits = {0, 0};
    played.game =
        kept_with(played.arena, new Game(*played.arena, Game::Memory::modes, automata::Ticks{0}, limits, modes));
    if (best) common_->note(*played.game, modes);
    played.best = best;
  };
  for (PlayedGame& played : games) {
    if (!in_context(*played.arena, modes) || !(played.game->too_large() || played.game->find(modes))) continue;
    if (useful && played.best && played.game->too_large()) play(played, false);
    return played;
  }
  if (games.size() >= games_remembered) games.erase(games.begin());
  forget_large();
  PlayedGame& played = games.emplace_back();
  play(played, true);
  if (useful && played.game->too_large()) play(played, false);
  return played;
}

SolvedGame Strategist::solved(PlayedGame& played, std::uint32_t start, const std::vector<std::size_t>& parts) {
  auto& known = played.solutions;
  const bool one = !known.empty() && known.begin()->second->is_of_all_nodes();
  if (!one && known.size() >= solutions_remembered) known.clear();
  auto& solution = one ? known.begin()->second : known[start];
  if (!solution) solution = std::make_shared<const Solution>(*played.game, start);
  return {played.game, solution, start, parts, played.best};
}

/// A game that is told keeps its arena.
std::shared_ptr<const Game> Strategist::kept_with(std::shared_ptr<Arena> arena, const Game* game) {
  return {game, [arena = std::move(arena)](const Game* told) { delete told; }};
}

/// Whether its components may come to no more than so many combinations of modes, each by itself.
bool Strategist::has_at_most(std::size_t most, const Group& group, const Modes& modes) const {
  std::size_t combinations = 1;
  for (const ComponentId c : group.played()) {
    std::size_t reached = 0;
    for (std::size_t m = 0; m < graph_.mode_count(c); ++m)
      reached += graph_.leads(c, modes[c.index()], automata::ModeId(m)) ? 1 : 0;
    combinations *= reached;
    if (combinations > most) return false;
  }
  return true;
}

/// Whether a game is begun at all.
bool Strategist::is_small(const Group& group, const Modes& modes) const {
  return has_at_most(group.least.empty() ? most_combinations : few_combinations, group, modes);
}

/// Whether the group is small enough; then it is solved, with all that its strategy disturbs. Where that is too much to
/// solve with all actions, or takes long, it is solved with the least components that will do. Else the strategy stands
/// without what it disturbs, if no harm can come of that; it is not proved best then.
bool Strategist::solve_group(Group& group, const Modes& modes) {
  bool tries_least = !holds_;
  const bool least_first = least_ == Least::all || !has_at_most(some_combinations, group, modes);
  if (tries_least && least_first && solve_least(group, modes)) return true;
  std::optional<Group> smaller;   // solved, without what it disturbs
  std::vector<ComponentId> more;  // what it disturbs
  for (;;) {
    const bool small = is_small(group, modes);
    PlayedGame* played = small ? &game_of(group, modes, !tries_least) : nullptr;
    if (tries_least && (!small || played->game->too_large())) {
      if (solve_least(group, modes)) return true;
      tries_least = false;
      if (small) played = &game_of(group, modes);
    }
    if (played == nullptr || played->game->too_large()) {
      if (!smaller || !(holds_ ? harmless_held(*smaller, modes) : harmless(more))) return false;
      group = *std::move(smaller);
      group.solved->best = false;
      return true;
    }
    group.solved = solved(*played, *played->game->find(modes), group.parts);
    if (counts_ages_) count_ages(group, *played, modes);
    more = follow(group, modes);
    // Where it could be better, what the model may exclude beside the group may have to give way.
    const GameDecision& decision = group.solved->decision();
    if (decision.rank != Rank::sure || !decision.lasts)
      more = joined(more, neighbours(group.components, group.game().arena().controls()));
    if (more.empty()) return true;
    smaller = group;
    group.components = joined(group.components, more);
  }
}

Strategist::Answer Strategist::from(const Modes& modes, const StrategyPosition& position) {
  counts_ages_ = cycle_.has_value();
  without_least_.clear();
  Answer answer = this->answer(modes, position);
  // What ages make of groups may be too large where groups over modes are not.
  if (answer.solved || !counts_ages_) return answer;
  counts_ages_ = false;
  answer = this->answer(modes, {});
  answer.bounds_counted = false;
  return answer;
}

Strategist::Answer Strategist::answer(const Modes& modes, const StrategyPosition& position) {
  Answer answer;
  Apart apart, in_turn;
  std::vector<Group> groups = first_groups(modes, position);
  const ControlAction rest = resting_action(step_, modes);
  for (;;) {
    for (Group& group : groups) {
      if (!group.solved && !solve_group(group, modes)) return answer;
      if (group.solved->decision().rank != Rank::none) continue;
      answer.solved = true;
      answer.rank = Rank::none;
      answer.lasts = false;
      answer.action = rest;
      answer.best = group.solved->best;
      answer.bounds_counted = group.solved->bounds_counted;
      answer.groups = {*std::move(group.solved)};
      return answer;
    }
    if (merge_touching(groups, modes, in_turn) || merge_passing(groups, modes, apart)) continue;
    answer = {};
    if (!apart.empty() && !judge_together(groups, modes, apart, answer)) continue;
    set_turns(groups, in_turn);
    answer.action = rest;
    for (const Group& group : groups) {
      const GameDecision& choice = group.solved->decision();
      if (choice.edge == GameDecision::no_edge || group.later) continue;
      const Game& game = *group.solved->game;
      const ControlAction& action = game.arena().action(game.edges()[choice.edge].action);
      for (const std::size_t i : game.arena().controls()) {
        if (action[i] != rest[i]) answer.action[i] = action[i];
      }
    }
    // Commands that the model excludes together are those of one group.
    if (groups.size() == 1 || step_.consistent(modes, answer.action)) break;
    merge_all(groups);
  }
  answer.solved = true;
  for (Group& group : groups) {
    answer.rank = std::max(answer.rank, group.solved->decision().rank);
    answer.lasts = answer.lasts && group.solved->decision().lasts;
    answer.best = answer.best && group.solved->best && in_turn.empty();
    answer.bounds_counted = answer.bounds_counted && group.solved->bounds_counted;
    (group.later ? answer.later : answer.groups).push_back(*std::move(group.solved));
  }
  return answer;
}

}  // namespace rmpl::runtime
