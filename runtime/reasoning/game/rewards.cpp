// Rewards as targets of sure strategies, the greatest first.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/rewards.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <set>

#include "base/strong_components.hpp"

namespace rmpl::runtime {

namespace {

constexpr std::int64_t unknown = std::numeric_limits<std::int64_t>::max();

/// The action that rests, where there is one.
const Game::Edge* rest_of(const Game& game, std::uint32_t n) {
  const Game::Node& node = game.nodes()[n];
  return node.count == 0 ? nullptr : &game.edges()[node.first];
}

template <class Visit>
void for_each_at_rest(const Game& game, std::uint32_t n, const Visit& visit) {
  const Game::Edge* rest = rest_of(game, n);
  for (std::uint32_t o = 0; rest != nullptr && o < rest->count; ++o) visit(game.outcomes()[rest->first + o].node);
}

/// Of what resting leads to.
base::StrongComponents classes_at_rest(const Game& game) {
  return base::strong_components(game.nodes().size(), [&](std::size_t n, std::size_t o) -> std::optional<std::size_t> {
    const Game::Edge* rest = rest_of(game, static_cast<std::uint32_t>(n));
    if (rest == nullptr || o >= rest->count) return std::nullopt;
    return game.outcomes()[rest->first + o].node;
  });
}

}  // namespace

GameRewards::GameRewards(const Game& game) : game_(game), backward_(game) {
  GameSet permitted(game.edges().size());
  for (std::uint32_t e = 0; e < permitted.size(); ++e) permitted[e] = game.edges()[e].permitted;
  kept_ = kept_nodes(game, backward_, permitted);
  find_restful();
  find_values();
  find_permitted();
  std::set<std::int64_t, std::greater<>> rewards;
  for (std::uint32_t n = 0; n < values_.size(); ++n) {
    if (restful_[n]) rewards.insert(values_[n]);
  }
  for (const std::int64_t reward : rewards) {
    Level level{reward, GameSet(values_.size()), {}};
    for (std::uint32_t n = 0; n < values_.size(); ++n) level.target[n] = restful_[n] && values_[n] >= reward;
    levels_.push_back(std::move(level));
  }
}

void GameRewards::find_restful() {
  restful_ = kept_;
  std::vector<std::uint32_t> lost;
  std::vector<std::vector<std::uint32_t>> before(restful_.size());
  for (std::uint32_t n = 0; n < restful_.size(); ++n) {
    for_each_at_rest(game_, n, [&](std::uint32_t then) { before[then].push_back(n); });
    const Game::Edge* rest = rest_of(game_, n);
    // Where resting leads nowhere that is possible, it keeps nothing.
    if (rest == nullptr || rest->dead) restful_[n] = false;
    if (!restful_[n]) lost.push_back(n);
  }
  while (!lost.empty()) {
    const std::uint32_t n = lost.back();
    lost.pop_back();
    for (const std::uint32_t earlier : before[n]) {
      if (!restful_[earlier]) continue;
      restful_[earlier] = false;
      lost.push_back(earlier);
    }
  }
}

void GameRewards::find_values() {
  const base::StrongComponents found = classes_at_rest(game_);
  const std::vector<std::size_t>& classes = found.number;
  std::vector<std::int64_t> own(found.count, unknown), least(found.count, unknown);
  std::vector<std::vector<std::size_t>> next(found.count);
  for (std::uint32_t n = 0; n < classes.size(); ++n) {
    own[classes[n]] = std::min(own[classes[n]], game_.position(n).reward);
    for_each_at_rest(game_, n, [&](std::uint32_t then) {
      if (classes[then] != classes[n]) next[classes[n]].push_back(classes[then]);
    });
  }
  for (std::size_t c = 0; c < found.count; ++c) {
    if (next[c].empty()) least[c] = own[c];
    for (const std::size_t then : next[c]) least[c] = std::min(least[c], least[then]);
  }
  for (const std::size_t c : classes) values_.push_back(least[c]);
}

void GameRewards::find_permitted() {
  permitted_.assign(game_.edges().size(), false);
  for (std::uint32_t e = 0; e < permitted_.size(); ++e) {
    const Game::Edge& edge = game_.edges()[e];
    if (!edge.permitted || !kept_[backward_.node_of[e]]) continue;
    bool stays = true;
    for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
      const Game::Outcome& outcome = game_.outcomes()[o];
      stays = stays && kept_[outcome.node] && !outcome.irreversible;
    }
    permitted_[e] = stays;
  }
}

const Chain& GameRewards::chain(Level& level) {
  if (!level.chain) level.chain.emplace(game_, backward_, permitted_, level.target, no_cost_);
  return *level.chain;
}

std::optional<GameRewards::Pursued> GameRewards::from(std::uint32_t node) {
  if (!kept_[node]) return std::nullopt;
  for (Level& level : levels_) {
    if (level.reward <= values_[node]) return std::nullopt;
    const Chain::State& state = chain(level).at(node);
    if (state.rank == Rank::sure && state.edge != GameDecision::no_edge)
      return Pursued{state.edge, state.cost, level.reward, values_[node]};
  }
  return std::nullopt;
}

std::uint32_t GameRewards::edge(const Pursued& pursued, std::uint32_t node) {
  const auto level =
      std::find_if(levels_.begin(), levels_.end(), [&](const Level& l) { return l.reward == pursued.reward; });
  return level == levels_.end() ? GameDecision::no_edge : chain(*level).at(node).edge;
}

}  // namespace rmpl::runtime
