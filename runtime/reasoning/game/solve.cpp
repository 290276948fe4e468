// Both targets, each way: the level of the start, then the least cost.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/solve.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "base/strong_components.hpp"
#include "runtime/reasoning/game/chain.hpp"
#include "runtime/reasoning/game/ways.hpp"

namespace rmpl::runtime {

namespace {

/// Whether some component has modes in the game with different rewards.
bool has_rewards(const Game& game) {
  const Arena& arena = game.arena();
  for (std::size_t i = 0; i < arena.components().size(); ++i) {
    const std::size_t c = arena.components()[i].index();
    for (std::uint32_t n = 1; n < game.nodes().size(); ++n) {
      if (arena.reward(i, game.position(n).modes[c]) != arena.reward(i, game.position(0).modes[c])) return true;
    }
  }
  return false;
}

/// What keeps the goal: resting where that does, else the action that takes and disturbs the least at worst.
std::uint32_t keeping(const Game& game, const GameSet& keeps, std::uint32_t n) {
  const Game::Node& node = game.nodes()[n];
  if (keeps[node.first]) return node.first;
  using Key = std::tuple<std::int64_t, std::int64_t, std::uint32_t, Arena::Order>;
  std::optional<Key> best;
  std::uint32_t chosen = GameDecision::no_edge;
  for (std::uint32_t e = node.first; e < node.first + node.count; ++e) {
    const Game::Edge& edge = game.edges()[e];
    if (!keeps[e]) continue;
    std::pair<std::int64_t, std::int64_t> worst{0, 0};
    for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
      const StepCost& cost = game.outcomes()[o].cost;
      worst = std::max(worst, {cost.irreversible, cost.disturbed});
    }
    const Key key{worst.first, worst.second, edge.off, game.arena().order(edge.action)};
    if (best && *best <= key) continue;
    best = key;
    chosen = e;
  }
  return chosen;
}

/// By node where the goal holds and cannot be kept: the action with which it holds for the longest time at worst, of
/// several the one with the fewest controls off idle, then the first.
std::vector<std::uint32_t> longest(const Game& game, const GameSet& kept) {
  std::vector<std::optional<std::int64_t>> times(game.nodes().size());
  for (std::uint32_t n = 0; n < times.size(); ++n) {
    if (game.position(n).goal && !kept[n]) times[n] = 0;
  }
  const auto time = [&](const Game::Edge& edge) {
    std::optional<std::int64_t> least;
    for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
      const Game::Outcome& outcome = game.outcomes()[o];
      const std::int64_t all = Cost::sum_of_times(outcome.soonest, times[outcome.node].value_or(0));
      if (!least || all < *least) least = all;
    }
    return least.value_or(0);
  };
  // Each round sees a step further; none is longer than there are nodes, as what can be kept is left out.
  bool changed = true;
  for (std::size_t round = 0; changed && round <= times.size(); ++round) {
    changed = false;
    for (std::uint32_t n = 0; n < times.size(); ++n) {
      if (!times[n]) continue;
      const Game::Node& node = game.nodes()[n];
      for (std::uint32_t e = node.first; e < node.first + node.count; ++e) {
        if (!game.edges()[e].permitted) continue;
        const std::int64_t found = time(game.edges()[e]);
        if (found <= *times[n]) continue;
        times[n] = found;
        changed = true;
      }
    }
  }
  std::vector<std::uint32_t> result(times.size(), GameDecision::no_edge);
  for (std::uint32_t n = 0; n < times.size(); ++n) {
    if (!times[n]) continue;
    const Game::Node& node = game.nodes()[n];
    for (std::uint32_t e = node.first; e < node.first + node.count; ++e) {
      const Game::Edge& edge = game.edges()[e];
      if (!edge.permitted || time(edge) != *times[n]) continue;
      if (result[n] == GameDecision::no_edge || edge.off < game.edges()[result[n]].off) result[n] = e;
    }
  }
  return result;
}

/// What keeping the goal comes back to for ever, from each node where it is kept.
class Keeping {
 public:
  /// `edges`: by node, what is sent there to keep the goal; none where it is not kept.
  Keeping(const Game& game, std::vector<std::uint32_t> edges)
      : game_(game),
        edges_(std::move(edges)),
        classes_(base::strong_components(
            edges_.size(), [&](std::size_t n, std::size_t o) { return next(static_cast<std::uint32_t>(n), o); })) {}

  [[nodiscard]] std::uint32_t edge(std::uint32_t n) const { return edges_[n]; }

  /// Where the goal is kept, the worst worth and reward of the nodes that come again for ever in place of the node's
  /// own.
  void settle(std::vector<Cost>& costs) const {
    constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
    std::vector<Cost> worst(classes_.count);
    for (Cost& cost : worst) cost.worth = cost.reward = least;
    const auto raise = [](Cost& cost, const Cost& by) {
      cost.worth = std::max(cost.worth, by.worth);
      cost.reward = std::max(cost.reward, by.reward);
    };
    for (std::uint32_t n = 0; n < edges_.size(); ++n) raise(worst[classes_.number[n]], costs[n]);
    // Successors have the smaller numbers.
    std::vector<std::vector<std::uint32_t>> members(classes_.count);
    for (std::uint32_t n = 0; n < edges_.size(); ++n) {
      if (edges_[n] != GameDecision::no_edge) members[classes_.number[n]].push_back(n);
    }
    for (std::size_t c = 0; c < members.size(); ++c) {
      Cost then;
      then.worth = then.reward = least;
      for (const std::uint32_t n : members[c]) {
        for (std::size_t o = 0; const auto to = next(n, o); ++o) {
          if (classes_.number[*to] != c) raise(then, worst[classes_.number[*to]]);
        }
      }
      if (then.worth != least) worst[c] = then;
      for (const std::uint32_t n : members[c]) {
        costs[n].worth = worst[c].worth;
        costs[n].reward = worst[c].reward;
      }
    }
  }

 private:
  [[nodiscard]] std::optional<std::size_t> next(std::uint32_t n, std::size_t o) const {
    if (edges_[n] == GameDecision::no_edge || o >= game_.edges()[edges_[n]].count) return std::nullopt;
    return game_.outcomes()[game_.edges()[edges_[n]].first + o].node;
  }

  const Game& game_;
  std::vector<std::uint32_t> edges_;
  base::StrongComponents classes_;
};

}  // namespace

Solution::Solution(const Game& game, std::uint32_t start) { solve(game, start, nullptr); }

Solution::Solution(const Game& game, std::uint32_t start, const std::vector<std::vector<bool>>& counted) {
  solve(game, start, &counted);
}

void Solution::solve(const Game& game, std::uint32_t start, const std::vector<std::vector<bool>>* counted_by_way) {
  decisions_.resize(game.nodes().size());
  const Backward backward(game);
  GameSet permitted(game.edges().size()), goal(game.nodes().size());
  for (std::uint32_t e = 0; e < permitted.size(); ++e) permitted[e] = game.edges()[e].permitted;
  for (std::uint32_t n = 0; n < goal.size(); ++n) goal[n] = game.position(n).goal;
  kept_ = kept_nodes(game, backward, permitted);
  const GameSet keeps = keeping_edges(game, backward, permitted, kept_);
  const std::vector<std::uint32_t> holds = longest(game, kept_);
  std::vector<std::uint32_t> kept_by(game.nodes().size(), GameDecision::no_edge);
  for (std::uint32_t n = 0; n < kept_by.size(); ++n) {
    if (kept_[n]) kept_by[n] = keeping(game, keeps, n);
  }
  const Keeping lasts(game, std::move(kept_by));

  const Arena& arena = game.arena();
  const auto terminal = [&](const std::vector<bool>& counted) {
    std::vector<Cost> costs(game.nodes().size());
    for (std::uint32_t n = 0; n < costs.size(); ++n) {
      if (!goal[n]) continue;
      const Position& end = game.position(n);
      costs[n].reward = -end.reward;
      for (std::size_t i = 0; i < counted.size(); ++i) {
        const std::size_t c = arena.components()[i].index();
        const std::int64_t gain = arena.reward(i, end.modes[c]) - arena.reward(i, game.position(start).modes[c]);
        costs[n].worth -= counted[i] ? gain : std::min<std::int64_t>(0, gain);
      }
      // What is lost in the very next cycle, however lucky.
      if (holds[n] == GameDecision::no_edge || !game.edges()[holds[n]].at_once) continue;
      const Game::Edge& edge = game.edges()[holds[n]];
      std::optional<std::int64_t> lost;
      for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o)
        lost = std::min<std::int64_t>(lost.value_or(game.outcomes()[o].cost.lost), game.outcomes()[o].cost.lost);
      costs[n].lost = lost.value_or(0);
    }
    lasts.settle(costs);
    return costs;
  };
  of_all_nodes_ = counted_by_way == nullptr && !has_rewards(game);
  std::vector<std::vector<bool>> ways{{}};
  if (counted_by_way != nullptr) {
    ways = *counted_by_way;
  } else if (!of_all_nodes_) {
    const GameWays found(game, backward, start);
    const std::vector<std::uint64_t> none{0};
    if (found.countable()) {
      ways.clear();
      for (const std::uint64_t way : kept_[start] ? none : found.find()) ways.push_back(found.counted(way));
    }
  }
  std::optional<std::pair<Chain, Chain>> best;
  std::optional<Cost> least;
  for (const std::vector<bool>& way : ways) {
    const auto costs = terminal(way);
    Chain lasting(game, backward, permitted, kept_, costs), passing(game, backward, permitted, goal, costs);
    const Level level = best_level(lasting.at(start).rank, passing.at(start).rank);
    const Cost cost = (level.lasts ? lasting : passing).at(start).cost;
    if (least && *least <= cost) continue;
    least = cost;
    best.emplace(std::move(lasting), std::move(passing));
  }
  for (std::uint32_t n = 0; n < decisions_.size(); ++n) {
    const Level level = best_level(best->first.at(n).rank, best->second.at(n).rank);
    const Chain::State& state = (level.lasts ? best->first : best->second).at(n);
    GameDecision& decision = decisions_[n];
    decision = {GameDecision::Purpose::reach, level.rank, level.lasts, state.edge, state.cost};
    if (kept_[n]) {
      decision.purpose = GameDecision::Purpose::keep;
      decision.edge = lasts.edge(n);
    } else if (goal[n] && !(level.rank != Rank::none && level.lasts)) {
      decision.purpose = GameDecision::Purpose::hold;
      decision.edge = holds[n];
    } else if (level.rank == Rank::none) {
      decision.purpose = GameDecision::Purpose::none;
      decision.edge = game.nodes()[n].count > 0 ? game.nodes()[n].first : GameDecision::no_edge;
    }
  }
}

}  // namespace rmpl::runtime
