// Least groups: few components whose answer is that of all, and the certificate for it (semantics 5).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "runtime/reasoning/game/free_arena.hpp"
#include "runtime/reasoning/game/sorted_sets.hpp"
#include "runtime/reasoning/game/strategist.hpp"
#include "runtime/reasoning/game/ways.hpp"
#include "runtime/reasoning/nominal/idling.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Modes;

namespace {

constexpr Game::Limits relaxed_limits{std::size_t{1} << 12, std::size_t{1} << 14};
constexpr std::size_t most_edges_looked_at = std::size_t{1} << 12;  // at what they do outside

/// The components outside that help a strategy of the relaxed game on its runs: those that have to leave their modes so
/// that its steps are enabled, or are not.
std::vector<ComponentId> helpers(const Game& game, FreeArena& arena, const Solution& solution) {
  std::vector<ComponentId> found;
  std::vector<bool> seen(game.nodes().size());
  std::vector<std::uint32_t> open{0};
  seen[0] = true;
  const auto leads_on = [&](std::uint32_t n, const Game::Edge& edge) {
    std::optional<Cost> worst;
    bool moves = false;
    for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
      const Game::Outcome& outcome = game.outcomes()[o];
      const GameDecision& then = solution.at(outcome.node);
      if (then.rank != Rank::sure || !then.lasts) return false;
      moves = moves || outcome.node != n;
      const Cost cost = outcome.cost + then.cost;
      if (!worst || *worst < cost) worst = cost;
    }
    return edge.permitted && moves && worst && *worst == solution.at(n).cost;
  };
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    if (solution.at(n).purpose != GameDecision::Purpose::reach) continue;
    const Game::Node& node = game.nodes()[n];
    const auto first = game.edges().begin() + node.first;
    const auto edge = std::find_if(first, first + node.count, [&](const Game::Edge& e) { return leads_on(n, e); });
    if (edge == first + node.count) continue;
    const Position& position = game.position(n);
    const ControlAction& action = arena.action(edge->action);
    for (std::size_t m = 0; position.free && m < arena.components().size(); ++m) {
      const LocalMoves& moves = *position.actions[edge->entry].moves[m];
      for (const LocalMoves::Exit& exit : moves.exits)
        found = joined(found, arena.helpers(m, position.modes, exit.transition, action));
      const LocalMoves held = arena.moves_of(arena.components()[m], position.modes, action);
      for (const LocalMoves::Exit& exit : held.exits) {
        if (std::find(moves.exits.begin(), moves.exits.end(), exit) != moves.exits.end()) continue;
        for (const ComponentId c :
             arena.deciding(arena.components()[m], position.modes[arena.components()[m].index()]).components) {
          if (arena.may_help(c)) insert(found, c);
        }
      }
    }
    for (std::uint32_t o = edge->first; o < edge->first + edge->count; ++o) {
      const std::uint32_t then = game.outcomes()[o].node;
      if (!seen[then]) open.push_back(then);
      seen[then] = true;
    }
  }
  return found;
}

/// The components outside that let commands do something which are on a way of the relaxed game alone.
std::vector<ComponentId> helpers(const FreeArena& arena, const std::vector<std::vector<GameWays::Command>>& own,
                                 const std::vector<std::vector<GameWays::Command>>& free) {
  std::vector<ComponentId> found;
  for (const auto& way : free) {
    for (const GameWays::Command& command : way) {
      const bool known = std::any_of(own.begin(), own.end(), [&](const auto& other) {
        return std::find(other.begin(), other.end(), command) != other.end();
      });
      if (known) continue;
      for (const ComponentId member : arena.components()) {
        for (std::size_t m = 0; m < arena.plant()[member].modes.size(); ++m) {
          const automata::Support& deciding = arena.deciding(member, ModeId(m));
          if (!deciding.reads_control(command.first)) continue;
          for (const ComponentId c : deciding.components) {
            if (arena.may_help(c)) insert(found, c);
          }
        }
      }
    }
  }
  return found;
}

/// The commands of all ways, and by way the components whose gains count.
struct Ways {
  std::vector<std::vector<GameWays::Command>> commands;
  std::vector<std::vector<bool>> counted;
};

std::optional<Ways> ways_of(const Game& game, std::uint32_t start) {
  const Backward backward(game);
  const GameWays ways(game, backward, start);
  if (!ways.countable()) return std::nullopt;
  Ways result;
  for (const std::uint64_t way : ways.find()) {
    result.commands.push_back(ways.commands(way));
    result.counted.push_back(ways.counted(way));
  }
  return result;
}

/// Whether both games do the same in their first nodes, at the same cost.
bool same(const SolvedGame& solved, const Game& relaxed, const Solution& bound) {
  const GameDecision &one = solved.decision(), &other = bound.at(0);
  if (other.rank != Rank::sure || !other.lasts || one.purpose != other.purpose) return false;
  if (one.edge == GameDecision::no_edge || other.edge == GameDecision::no_edge) return false;
  if (one.purpose == GameDecision::Purpose::reach && one.cost != other.cost) return false;
  const Game::Edge &edge = solved.game->edges()[one.edge], &free = relaxed.edges()[other.edge];
  return !relaxed.position(0).actions[free.entry].frees && edge.waits == free.waits &&
         solved.game->arena().action(edge.action) == relaxed.arena().action(free.action);
}

}  // namespace

/// Of these components those that may leave their mode at rest, each looked at by itself; be it for a mode that is
/// impossible, so that they are stuck.
std::vector<ComponentId> Strategist::restless(const std::vector<ComponentId>& components, const Modes& modes) const {
  Reached at_rest = only(graph_, modes);
  spread_at_rest(graph_, at_rest);
  std::vector<ComponentId> result;
  const auto leaves = [&](const NominalTransition& t) {
    if (t.from == t.to) return false;
    bool comes = !t.all_preconditions;
    for (std::size_t p = 0; p < t.preconditions.size() && !comes; ++p)
      comes = t.silent[p] && std::all_of(t.preconditions[p].begin(), t.preconditions[p].end(),
                                         [&](const Requirement& r) { return graph_.meets(r, at_rest); });
    return comes;
  };
  for (const ComponentId c : components) {
    const auto& transitions = graph_.transitions(c);
    const bool may = std::any_of(transitions.begin(), transitions.end(), [&](const NominalTransition& t) {
      return at_rest[c.index()][t.from.index()] && leaves(t);
    });
    if (may) result.push_back(c);
  }
  return result;
}

/// Starts with few components, and adds those without which there is no certificate. Where no ages were in play, what
/// failed would fail without them, too.
bool Strategist::solve_least(Group& group, const Modes& modes) {
  const Key key{group.parts, group.components};
  if (without_least_.contains(key) || !tolerates_all_commands()) return false;
  Group few{.parts = group.parts, .components = group.components};
  few.least = restless(group.components, modes);
  for (const std::size_t p : group.parts) {
    for (const ComponentId c : goal_.read_by(p)) insert(few.least, c);
  }
  bool aged = false;
  for (;;) {
    PlayedGame* const played = is_small(few, modes) ? &game_of(few, modes, false) : nullptr;
    if (played == nullptr || played->game->too_large()) break;
    few.solved = solved(*played, *played->game->find(modes), few.parts);
    if (counts_ages_) count_ages(few, *played, modes);
    aged = aged || few.solved->game->memory() == Game::Memory::ages;
    const Certificate found = certificate(few, modes);
    if (found.holds) {
      group = std::move(few);
      return true;
    }
    const std::size_t before = few.least.size();
    few.least = joined(few.least, found.more);
    if (few.least.size() == before) break;
    few.components = joined(few.components, found.wider);
  }
  if (!aged) without_least_.insert(key);
  return false;
}

/// What is disturbed of the components on which the group rests joins it at once. What is disturbed beside them joins
/// it as it would join all of them: once the strategy is theirs.
Strategist::Certificate Strategist::certificate(Group& group, const Modes& modes) {
  const auto without = [](std::vector<ComponentId> set, const std::vector<ComponentId>& less) {
    std::erase_if(set, [&](ComponentId c) { return std::binary_search(less.begin(), less.end(), c); });
    return set;
  };
  const std::vector<ComponentId> disturbed = follow(group, modes);
  std::vector<ComponentId> wider = without(disturbed, group.components);
  std::vector<ComponentId> more = without(disturbed, wider);
  if (more.empty()) more = moved_outside(group, group.components, modes, false);
  if (!more.empty()) return {false, std::move(more), {}};
  if (!rests_for_good(*group.solved)) {
    Certificate found = relaxed(group, modes);
    if (!found.holds) return found;
  }
  // What comes by itself may come to modes that the model excludes together with those of the strategy.
  const std::vector<ComponentId> beside = neighbours(group.touched, {});
  more = joined(joined(wider, restless(beside, modes)), moved_outside(group, beside, modes, false));
  more = without(std::move(more), group.least);
  if (more.empty()) {
    group.rests_on = joined(group.components, beside);
    group.controls = controls_of(group, group.rests_on);
    return {true, {}, {}};
  }
  wider = joined(joined(wider, beside), more);
  return {false, std::move(more), std::move(wider)};
}

/// Of these components those outside that may do something else than they do at rest: where the executive rests on the
/// runs of the strategy, or, everywhere, whatever it does.
std::vector<ComponentId> Strategist::moved_outside(const Group& group, const std::vector<ComponentId>& components,
                                                   const Modes& modes, bool everywhere) {
  const Game& game = group.game();
  Arena& arena = game.arena();
  const ControlAction rest = resting_action(step_, modes);
  std::vector<ComponentId> readers = arena.readers(modes);
  std::erase_if(readers, [&](ComponentId c) { return !std::binary_search(components.begin(), components.end(), c); });
  std::vector<LocalMoves> undisturbed;
  undisturbed.reserve(readers.size());
  for (const ComponentId c : readers) undisturbed.push_back(arena.moves_of(c, modes, rest));
  std::vector<ComponentId> moved;
  Modes joint = modes;
  std::vector<bool> seen(game.nodes().size());
  std::vector<std::uint32_t> open = group.nodes;
  for (const std::uint32_t n : open) seen[n] = true;
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    const Game::Node& node = game.nodes()[n];
    for (const ComponentId c : arena.components()) joint[c.index()] = game.position(n).modes[c.index()];
    const std::uint32_t last = node.first + (everywhere ? node.count : std::min<std::uint32_t>(node.count, 1));
    for (std::uint32_t e = node.first; e < last; ++e) {
      const Game::Edge& edge = game.edges()[e];
      for (std::size_t r = 0; r < readers.size(); ++r) {
        if (arena.moves_of(readers[r], joint, arena.action(edge.action)) != undisturbed[r]) insert(moved, readers[r]);
      }
      for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
        const std::uint32_t then = game.outcomes()[o].node;
        if (!seen[then]) open.push_back(then);
        seen[then] = true;
      }
    }
  }
  return moved;
}

/// Whether the model excludes no commands, so that the executive rests with all controls idle.
bool Strategist::tolerates_all_commands() {
  const auto& islands = step_.locality().islands();
  for (std::size_t i = 0; i < islands.size(); ++i) {
    if (!islands[i].support.controls.empty() && common_->excludes(i)) return false;
  }
  return true;
}

/// Whether the strategy is sure and lasts, and does the same at the same cost as that of the relaxed game, in which the
/// components outside are free: the strategy of all components cannot be better then, nor another one.
Strategist::Certificate Strategist::relaxed(const Group& group, const Modes& modes) {
  const SolvedGame& solved = *group.solved;
  const std::vector<ComponentId> whole = joined(group.components, neighbours(group.touched, {}));
  const WithinReach reach = within_reach(graph_, goal_, modes, whole);
  const bool aged = solved.game->memory() == Game::Memory::ages;
  const auto is_outside = [&](ComponentId c) { return !std::binary_search(group.least.begin(), group.least.end(), c); };
  // In dense time what is outside could end a wait at any time.
  if (aged && cycle_->count == 0) {
    for (const ComponentId c : whole) {
      for (const NominalTransition& t : graph_.transitions(c)) {
        if (is_outside(c) && t.timed && reach.modes[c.index()][t.from.index()]) return {};
      }
    }
  }
  FreeArena arena(
      step_, graph_, goal_, group.parts, group.least, modes,
      [this](std::size_t island) { return common_->excludes(island); }, reach);
  const Game game(arena, solved.game->memory(), aged ? *cycle_ : automata::Ticks{0}, relaxed_limits, modes,
                  aged ? std::optional(solved.game->ages(solved.start)) : std::nullopt);
  if (game.too_large()) return {};
  // Gains count for what is on a way.
  const std::vector<ComponentId> gaining = this->gaining(whole, modes, reach);
  const GameDecision& decision = solved.decision();
  const bool best = decision.rank == Rank::sure && decision.lasts;
  const bool weighs = best && !gaining.empty() && decision.purpose == GameDecision::Purpose::reach;
  std::optional<Ways> own;
  if (weighs) own = ways_of(*solved.game, solved.start);
  if (weighs && !own) return {};
  std::vector<std::vector<bool>> counted(1, std::vector<bool>(group.least.size(), false));
  if (own) counted = own->counted;
  const Solution bound(game, 0, counted);
  // With others the game would not be that of all components.
  const auto without = [&](std::vector<ComponentId> set) {
    const bool known = std::includes(group.components.begin(), group.components.end(), set.begin(), set.end());
    return known ? Certificate{false, std::move(set), {}} : Certificate{};
  };
  if (bound.at(0).rank != Rank::sure || !bound.at(0).lasts) return {};
  if (!best || !same(solved, game, bound)) return without(helpers(game, arena, bound));
  if (!weighs) return {true, {}, {}};
  // The ways have to be those of all components: the same where these are free, and they move none of them.
  const auto free = ways_of(game, 0);
  if (!free || solved.game->edges().size() > most_edges_looked_at) return {};
  if (own->commands != free->commands) return without(helpers(arena, own->commands, free->commands));
  std::vector<ComponentId> more = moved_outside(group, whole, modes, true);
  for (const auto& way : own->commands) {
    for (const auto& [control, value] : way) {
      const automata::VariableId variable = step_.plant().controls[control].variable;
      for (const ComponentId c : gaining) {
        if (is_outside(c) && has_control(step_.plant()[c], variable)) insert(more, c);
      }
    }
  }
  return more.empty() ? Certificate{true, {}, {}} : without(std::move(more));
}

/// Of these components those that may come to modes of more reward.
std::vector<ComponentId> Strategist::gaining(const std::vector<ComponentId>& components, const Modes& modes,
                                             const WithinReach& reach) const {
  std::vector<ComponentId> result;
  for (const ComponentId c : components) {
    const auto& all = step_.plant()[c].modes;
    bool gains = false;
    for (std::size_t m = 0; m < all.size(); ++m)
      gains = gains || (reach.modes[c.index()][m] && all[m].reward > all[modes[c.index()].index()].reward);
    if (gains) result.push_back(c);
  }
  return result;
}

/// Controls that these components read.
std::vector<std::size_t> Strategist::controls_of(const Group& group, const std::vector<ComponentId>& components) const {
  std::vector<bool> read(step_.plant().controls.size());
  for (const ComponentId c : components) {
    for (std::size_t m = 0; m < graph_.mode_count(c); ++m) {
      for (const std::size_t i : group.game().arena().deciding(c, ModeId(m)).controls) read[i] = true;
    }
  }
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (read[i]) result.push_back(i);
  }
  return result;
}

}  // namespace rmpl::runtime
