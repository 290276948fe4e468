// Where bounds matter: groups over modes and ages, and the strategies in force (semantics 5).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <utility>

#include "runtime/reasoning/game/sorted_sets.hpp"
#include "runtime/reasoning/game/strategist.hpp"
#include "runtime/reasoning/game/ways.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Modes;

namespace {

// Beyond these a game over ages is too large. None is tried where the one over modes has more outcomes.
constexpr Game::Limits aged_limits{std::size_t{1} << 12, std::size_t{1} << 12};
constexpr Game::Limits few_ages{std::size_t{1} << 11, std::size_t{1} << 13, std::size_t{16}};
constexpr std::size_t aged_games_remembered = 16;  // of one group

}  // namespace

bool rests_for_good(const SolvedGame& solved) {
  const Game& game = *solved.game;
  std::vector<std::uint32_t> open{solved.start};
  std::vector<bool> seen(game.nodes().size());
  seen[solved.start] = true;
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    const GameDecision& decision = solved.solution->at(n);
    if (decision.purpose != GameDecision::Purpose::keep || decision.edge != game.nodes()[n].first) return false;
    const Game::Edge& edge = game.edges()[decision.edge];
    for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
      const std::uint32_t then = game.outcomes()[o].node;
      if (!seen[then]) open.push_back(then);
      seen[then] = true;
    }
  }
  return true;
}

namespace {

/// What is known where one of two things is.
std::vector<Age> either(std::vector<Age> a, const std::vector<Age>& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] = {std::min(a[i].least, b[i].least), std::max(a[i].most, b[i].most), std::min(a[i].charged, b[i].charged)};
  return a;
}

}  // namespace

/// Whether some component of the group may come to a mode with an exit whose bounds say something.
bool Strategist::bounds_matter(const Group& group, const Modes& modes) const {
  return std::any_of(group.components.begin(), group.components.end(), [&](ComponentId c) {
    const auto& transitions = graph_.transitions(c);
    return std::any_of(transitions.begin(), transitions.end(), [&](const NominalTransition& t) {
      if (!t.timed || !graph_.leads(c, modes[c.index()], t.from)) return false;
      const automata::Timing& timing = *step_.plant()[c].transitions[t.id.index()].timing;
      return timing.lower.count > 0 || !timing.upper.is_infinite();
    });
  });
}

/// Of a group that was solved over modes: over ages, too, where that can make a difference. Where the game over ages is
/// too large, its part with few ages stands if its strategy is surer than what is known without bounds.
void Strategist::count_ages(Group& group, const PlayedGame& over_modes, const Modes& modes) {
  if (!bounds_matter(group, modes) || rests_for_good(*group.solved)) {
    group.ages.reset();
    return;
  }
  group.solved->bounds_counted = false;
  const bool small = over_modes.best && over_modes.game->outcomes().size() <= aged_limits.outcomes;
  if (small && play_over_ages(
                   group, [&] { return over_modes.arena; }, aged_limits, modes))
    return;
  const SolvedGame without_bounds = *group.solved;
  const auto level = [](const SolvedGame& solved) {
    const GameDecision& decision = solved.decision();
    return level_number({decision.rank, decision.lasts});
  };
  if (level(without_bounds) == 0 || !group.least.empty()) return;
  const auto arena = [&] { return over_modes.best ? arena_of(group, modes, false) : over_modes.arena; };
  const bool surer = play_over_ages(group, arena, few_ages, modes) && level(*group.solved) < level(without_bounds);
  if (!surer) group.solved = without_bounds;
  group.solved->best = false;
}

/// Whether that game is not too large; then it is solved.
bool Strategist::play_over_ages(Group& group, const MakeArena& make_arena, const Game::Limits& limits,
                                const Modes& modes) {
  auto& games = aged_games_[{group.parts, group.played()}];
  for (PlayedGame& played : games) {
    if (played.best == limits.alike.has_value() || !in_context(*played.arena, modes)) continue;
    if (const auto start = played.game->find(modes, group.ages)) {
      if (played.game->too_large() && *start != 0) continue;
      if (played.game->too_large()) return false;
      group.solved = solved(played, *start, group.parts);
      return true;
    }
  }
  const std::shared_ptr<Arena> arena = make_arena();
  auto game = kept_with(arena, new Game(*arena, Game::Memory::ages, *cycle_, limits, modes, group.ages));
  if (games.size() >= aged_games_remembered) games.erase(games.begin());
  PlayedGame& played = games.emplace_back();
  played.arena = arena;
  played.game = std::move(game);
  played.best = !limits.alike;
  if (played.game->too_large()) return false;
  group.solved = solved(played, 0, group.parts);
  return true;
}

/// Whether the strategy in force of a group still holds: it leads on, and disturbs nothing outside.
bool Strategist::go_on(Group& group, const Modes& modes) {
  std::vector<ComponentId> whole;
  for (const std::size_t p : group.parts) whole = joined(whole, relevant_[p]);
  if (!std::includes(group.components.begin(), group.components.end(), whole.begin(), whole.end())) {
    group.least = std::exchange(group.components, {});
    group.components = joined(whole, group.least);
  }
  if (!is_small(group, modes)) return false;
  PlayedGame& played = game_of(group, modes, group.least.empty());
  if (played.game->too_large()) return false;
  group.solved = solved(played, *played.game->find(modes), group.parts);
  count_ages(group, played, modes);
  if (group.ages && group.solved->game->memory() == Game::Memory::modes) return false;
  if (!group.least.empty()) return certificate(group, modes).holds;
  return group.solved->decision().rank != Rank::none && follow(group, modes).empty();
}

/// Groups in force, and all other parts of the goal, those together that read the same component.
std::vector<Strategist::Group> Strategist::first_groups(const Modes& modes, const StrategyPosition& position) {
  std::vector<Group> groups;
  std::vector<bool> placed(goal_.parts());
  for (const StrategyPosition::Group& known : position.groups(goal_text_)) {
    Group group{.parts = known.parts, .components = known.components};
    group.ages = known.ages;
    if (!go_on(group, modes)) continue;
    for (const std::size_t p : group.parts) placed[p] = true;
    groups.push_back(std::move(group));
  }
  for (std::size_t p = 0; p < goal_.parts(); ++p) {
    if (!placed[p]) groups.push_back({.parts = {p}, .components = relevant_[p]});
  }
  merge_common(groups);
  return groups;
}

/// Whether the goal of a group is kept by resting from these modes on: what is known of ages makes nothing better.
bool Strategist::rests_from(const SolvedGame& solved, const Modes& modes) {
  const Group group{.parts = solved.parts, .components = solved.game->arena().components()};
  PlayedGame& played = game_of(group, modes);
  if (played.game->too_large()) return false;
  return rests_for_good(this->solved(played, *played.game->find(modes), solved.parts));
}

std::shared_ptr<const StrategyEdges> Strategist::edges(const Answer& answer, const Modes& modes,
                                                       const ControlAction& sent) {
  std::vector<StrategyEdges::Group> result;
  for (const SolvedGame& solved : answer.groups) {
    const Game& game = *solved.game;
    const std::uint32_t chosen = solved.decision().edge;
    if (game.memory() == Game::Memory::modes || answer.rank == Rank::none || chosen == GameDecision::no_edge) continue;
    const Game::Edge& edge = game.edges()[chosen];
    const Arena& arena = game.arena();
    const ControlAction& own = arena.action(edge.action);
    const bool as_sent =
        std::all_of(arena.controls().begin(), arena.controls().end(), [&](std::size_t i) { return own[i] == sent[i]; });
    if (!as_sent) continue;
    std::map<std::vector<ModeId>, std::vector<Age>> known;  // by modes that are seen next
    const auto add = [&](std::uint32_t node) {
      if (game.is_fresh(node)) return;
      std::vector<ModeId> then;
      Modes joint = modes;
      for (const ComponentId c : arena.components()) {
        joint[c.index()] = game.position(node).modes[c.index()];
        then.push_back(joint[c.index()]);
      }
      if (rests_from(solved, joint)) return;
      const auto [at, fresh] = known.try_emplace(std::move(then), game.ages(node));
      if (!fresh) at->second = either(at->second, game.ages(node));
    };
    if (edge.waits) add(solved.start);
    for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) add(game.outcomes()[o].node);
    if (known.empty()) continue;
    StrategyEdges::Group group{solved.parts, arena.components(), {}, {}};
    for (const ComponentId c : arena.context()) group.context.emplace_back(c, modes[c.index()]);
    for (auto& [then, ages] : known) group.edges.push_back({then, std::move(ages)});
    result.push_back(std::move(group));
  }
  if (result.empty()) return nullptr;
  return std::make_shared<const StrategyEdges>(goal_text_, std::move(result));
}

}  // namespace rmpl::runtime
