// Ranks by fixpoints, costs by Dijkstra's algorithm.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/chain.hpp"

#include <algorithm>
#include <iterator>
#include <queue>
#include <tuple>
#include <utility>

namespace rmpl::runtime {

namespace {

/// How many choices of nature an action has, all of which have to lead on: to a sure strategy each outcome is one, to
/// hope all are one.
std::uint32_t choices(Rank rank, const Game::Edge& edge) {
  if (rank == Rank::sure) return edge.count;
  return rank == Rank::fair ? edge.choices : 1;
}

std::uint32_t choice_of(Rank rank, const Game::Edge& edge, const Game& game, std::uint32_t outcome) {
  if (rank == Rank::sure) return outcome - edge.first;
  return rank == Rank::fair ? game.outcomes()[outcome].choice : 0;
}

/// That something timed comes in the very cycle of a command is not what a strategy may hope for.
Cost charged(Rank rank, const Game::Outcome& outcome, const Cost& rest) {
  Cost cost = outcome.cost + rest;
  if (rank == Rank::hoped && outcome.coincides) ++cost.unbounded;
  return cost;
}

}  // namespace

Backward::Backward(const Game& game) : into(game.nodes().size()), node_of(game.edges().size()) {
  for (std::uint32_t n = 0; n < game.nodes().size(); ++n) {
    const Game::Node& node = game.nodes()[n];
    for (std::uint32_t e = node.first; e < node.first + node.count; ++e) {
      node_of[e] = n;
      const Game::Edge& edge = game.edges()[e];
      for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o)
        into[game.outcomes()[o].node].push_back({e, o});
    }
  }
}

namespace {

/// Takes away what no permitted action keeps in the set.
void shrink(const Game& game, const Backward& backward, const GameSet& permitted, GameSet& keep) {
  // By node the permitted actions that keep it, by edge the outcomes that do not.
  std::vector<std::uint32_t> good(keep.size(), 0), bad(game.edges().size(), 0), lost;
  for (std::uint32_t e = 0; e < game.edges().size(); ++e) {
    const Game::Edge& edge = game.edges()[e];
    for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
      if (!keep[game.outcomes()[o].node]) ++bad[e];
    }
    if (permitted[e] && bad[e] == 0) ++good[backward.node_of[e]];
  }
  const auto drop = [&](std::uint32_t n) {
    if (!keep[n]) return;
    keep[n] = false;
    lost.push_back(n);
  };
  for (std::uint32_t n = 0; n < keep.size(); ++n) {
    if (good[n] == 0) drop(n);
  }
  while (!lost.empty()) {
    const std::uint32_t n = lost.back();
    lost.pop_back();
    for (const auto& arc : backward.into[n]) {
      const std::uint32_t from = backward.node_of[arc.edge];
      if (bad[arc.edge]++ == 0 && permitted[arc.edge] && --good[from] == 0) drop(from);
    }
  }
}

/// Of edges in a set of nodes those that lead to a wait in it, whatever comes: of a node those by which it is nearest.
/// Resting is no distance. A node in which the executive could rest does something else only if resting goes round in
/// circles without a wait.
GameSet edges_to_waits(const Game& game, const Backward& backward, const GameSet& permitted, const GameSet& keep) {
  constexpr auto never = static_cast<std::uint32_t>(-1);
  GameSet result(game.edges().size()), found(keep.size());
  std::vector<std::uint32_t> left(game.edges().size()), open, ready;  // left: outcomes from which no wait was found
  for (std::uint32_t e = 0; e < result.size(); ++e) {
    const Game::Edge& edge = game.edges()[e];
    bool stays = permitted[e] && keep[backward.node_of[e]];
    for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) stays = stays && keep[game.outcomes()[o].node];
    left[e] = stays ? edge.count : never;
  }
  const auto rest_of = [&](std::uint32_t e) { return game.nodes()[backward.node_of[e]].first; };
  const auto take = [&](std::uint32_t e) {
    const std::uint32_t n = backward.node_of[e];
    result[e] = true;
    if (!found[n]) open.push_back(n);
    found[n] = true;
  };
  for (std::uint32_t e = 0; e < result.size(); ++e) {
    if (!game.edges()[e].waits || left[e] == never) continue;
    if (e == rest_of(e)) {
      take(e);
    } else {
      ready.push_back(e);
    }
  }
  for (;;) {
    while (!open.empty()) {
      const std::uint32_t n = open.back();
      open.pop_back();
      for (const auto& arc : backward.into[n]) {
        if (left[arc.edge] == never || --left[arc.edge] > 0 || found[backward.node_of[arc.edge]]) continue;
        if (arc.edge == rest_of(arc.edge)) {
          take(arc.edge);
        } else {
          ready.push_back(arc.edge);
        }
      }
    }
    // All at one distance at once: each is as good as another.
    std::erase_if(ready, [&](std::uint32_t e) { return found[backward.node_of[e]]; });
    std::vector<std::uint32_t> nearest;
    std::copy_if(ready.begin(), ready.end(), std::back_inserter(nearest),
                 [&](std::uint32_t e) { return left[rest_of(e)] == never; });
    if (nearest.empty()) nearest = ready;
    if (nearest.empty()) return result;
    for (const std::uint32_t e : nearest) take(e);
  }
}

}  // namespace

GameSet kept_nodes(const Game& game, const Backward& backward, const GameSet& permitted) {
  GameSet keep(game.nodes().size());
  for (std::uint32_t n = 0; n < keep.size(); ++n) keep[n] = game.position(n).goal;
  for (;;) {
    shrink(game, backward, permitted, keep);
    if (game.actions_take_time()) return keep;
    const GameSet edges = edges_to_waits(game, backward, permitted, keep);
    GameSet lasting(keep.size());
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      if (edges[e]) lasting[backward.node_of[e]] = true;
    }
    if (lasting == keep) return keep;
    keep = std::move(lasting);
  }
}

GameSet keeping_edges(const Game& game, const Backward& backward, const GameSet& permitted, const GameSet& kept) {
  if (!game.actions_take_time()) return edges_to_waits(game, backward, permitted, kept);
  GameSet result(permitted);
  for (std::uint32_t e = 0; e < result.size(); ++e) {
    const Game::Edge& edge = game.edges()[e];
    for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o)
      result[e] = result[e] && kept[game.outcomes()[o].node];
  }
  return result;
}

GameSet sure_nodes(const Game& game, const Backward& backward, const GameSet& permitted, const GameSet& target) {
  constexpr auto never = static_cast<std::uint32_t>(-1);
  GameSet result(target);
  std::vector<std::uint32_t> left(game.edges().size()), found;  // left: outcomes that have not led on
  for (std::uint32_t e = 0; e < left.size(); ++e) {
    const Game::Edge& edge = game.edges()[e];
    left[e] = permitted[e] && edge.count > 0 && edge.ends ? edge.count : never;
  }
  for (std::uint32_t n = 0; n < target.size(); ++n) {
    if (target[n]) found.push_back(n);
  }
  while (!found.empty()) {
    const std::uint32_t n = found.back();
    found.pop_back();
    for (const auto& arc : backward.into[n]) {
      const std::uint32_t from = backward.node_of[arc.edge];
      if (left[arc.edge] == never || --left[arc.edge] > 0 || result[from]) continue;
      result[from] = true;
      found.push_back(from);
    }
  }
  return result;
}

Chain::Chain(const Game& game, const Backward& backward, const GameSet& permitted, const GameSet& target,
             const std::vector<Cost>& terminal)
    : game_(game), backward_(backward), permitted_(permitted), target_(target), states_(game.nodes().size()) {
  for (std::uint32_t n = 0; n < target.size(); ++n) {
    if (target[n]) states_[n] = {Rank::sure, terminal.empty() ? Cost{} : terminal[n], GameDecision::no_edge};
  }
  if (std::find(target.begin(), target.end(), true) == target.end()) return;
  solve(Rank::sure, nullptr);
  const bool all = std::none_of(states_.begin(), states_.end(), [](const State& s) { return s.rank == Rank::none; });
  if (all) return;
  const GameSet fair = fair_nodes();
  solve(Rank::fair, &fair);
  solve(Rank::hoped, nullptr);
}

bool Chain::stays(const Game::Edge& edge, const GameSet& nodes) const {
  for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
    if (!nodes[game_.outcomes()[o].node]) return false;
  }
  return true;
}

/// Whether chance may lead to some of the nodes, whatever nature chooses.
bool Chain::may_come(const Game::Edge& edge, const GameSet& nodes) const {
  GameSet met(edge.choices);
  for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
    if (nodes[game_.outcomes()[o].node]) met[game_.outcomes()[o].choice] = true;
  }
  return edge.count > 0 && std::find(met.begin(), met.end(), false) == met.end();
}

/// From where the target stays within reach whatever comes (strong cyclic).
GameSet Chain::fair_nodes() const {
  GameSet outer(target_.size(), true);
  for (;;) {
    GameSet inner(target_.size());
    std::vector<std::uint32_t> found;
    const auto add = [&](std::uint32_t n) {
      if (inner[n]) return;
      inner[n] = true;
      found.push_back(n);
    };
    for (std::uint32_t n = 0; n < target_.size(); ++n) {
      if (target_[n]) add(n);
    }
    while (!found.empty()) {
      const std::uint32_t n = found.back();
      found.pop_back();
      for (const auto& arc : backward_.into[n]) {
        const Game::Edge& edge = game_.edges()[arc.edge];
        const std::uint32_t from = backward_.node_of[arc.edge];
        if (inner[from] || !outer[from] || !permitted_[arc.edge]) continue;
        if (stays(edge, outer) && may_come(edge, inner)) add(from);
      }
    }
    if (inner == outer) return outer;
    outer = std::move(inner);
  }
}

/// What an action costs from here on; nothing where some choice of nature does not lead on.
std::optional<Cost> Chain::cost(Rank rank, const Game::Edge& edge) const {
  std::vector<std::optional<Cost>> best(choices(rank, edge));
  for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
    const Game::Outcome& outcome = game_.outcomes()[o];
    const State& then = states_[outcome.node];
    if (then.rank == Rank::none) continue;
    const Cost cost = charged(rank, outcome, then.cost);
    auto& known = best[choice_of(rank, edge, game_, o)];
    if (!known || cost < *known) known = cost;
  }
  std::optional<Cost> worst;
  for (const auto& choice : best) {
    if (!choice) return std::nullopt;
    if (!worst || *worst < *choice) worst = choice;
  }
  return worst;
}

/// Dijkstra's algorithm over nodes (Knuth 1977). A node is final when it leaves the queue, as no step costs less than
/// nothing. An action counts as soon as each choice of nature has led on: it costs its worst choice, and a choice its
/// best outcome so far. To a sure strategy each outcome is a choice, so the worst so far is enough.
void Chain::solve(Rank rank, const GameSet* within) {
  using Entry = std::pair<Cost, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const std::size_t edges = game_.edges().size();
  std::vector<std::uint32_t> open(edges), first(edges);  // by edge: choices that have not led on; of its costs
  GameSet usable(edges), seeded(states_.size()), done(states_.size());
  std::uint32_t count = 0;
  for (std::uint32_t e = 0; e < edges; ++e) {
    const Game::Edge& edge = game_.edges()[e];
    usable[e] = permitted_[e] && edge.count > 0 && (rank != Rank::sure || edge.ends) &&
                (within == nullptr || ((*within)[backward_.node_of[e]] && stays(edge, *within)));
    if (!usable[e]) continue;
    open[e] = choices(rank, edge);
    first[e] = count;
    count += rank == Rank::sure ? 1 : open[e];
  }
  std::vector<std::optional<Cost>> costs(count);  // by choice; of a sure strategy by edge
  std::vector<std::optional<Cost>> best(states_.size());
  for (std::uint32_t n = 0; n < states_.size(); ++n) {
    seeded[n] = states_[n].rank != Rank::none;
    if (seeded[n]) queue.emplace(states_[n].cost, n);
  }
  while (!queue.empty()) {
    const auto [settled, node] = queue.top();
    queue.pop();
    if (done[node]) continue;
    done[node] = true;
    for (const auto& arc : backward_.into[node]) {
      const std::uint32_t e = arc.edge, from = backward_.node_of[e];
      if (!usable[e] || seeded[from] || done[from]) continue;
      const Game::Edge& edge = game_.edges()[e];
      Cost cost = charged(rank, game_.outcomes()[arc.outcome], settled);
      std::optional<Cost>* const known = &costs[first[e]];
      if (rank == Rank::sure) {
        if (!known->has_value() || **known < cost) *known = cost;
        if (--open[e] > 0) continue;
        cost = **known;
      } else {
        std::optional<Cost>& own = known[choice_of(rank, edge, game_, arc.outcome)];
        if (!own) --open[e];
        if (own && *own <= cost) continue;
        own = cost;
        if (open[e] > 0) continue;
        for (std::uint32_t c = 0; c < choices(rank, edge); ++c) cost = std::max(cost, *known[c]);
      }
      if (best[from] && *best[from] <= cost) continue;
      best[from] = cost;
      queue.emplace(cost, from);
    }
  }
  std::vector<std::uint32_t> fresh;
  for (std::uint32_t n = 0; n < states_.size(); ++n) {
    if (seeded[n] || !best[n]) continue;
    states_[n] = {rank, *best[n], GameDecision::no_edge};
    fresh.push_back(n);
  }
  // Of equal actions one that does something at once goes before a wait, then the first by order.
  for (const std::uint32_t n : fresh) {
    const Game::Node& node = game_.nodes()[n];
    std::uint32_t& chosen = states_[n].edge;
    for (std::uint32_t e = node.first; e < node.first + node.count; ++e) {
      const Game::Edge& edge = game_.edges()[e];
      if (!usable[e] || cost(rank, edge) != states_[n].cost) continue;
      const auto order = [&](std::uint32_t number) {
        const Game::Edge& of = game_.edges()[number];
        return std::tuple(of.waits, game_.arena().order(of.action));
      };
      if (chosen == GameDecision::no_edge || order(e) < order(chosen)) chosen = e;
    }
  }
}

}  // namespace rmpl::runtime
