// The strategies of all groups of a goal, put together.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/strategy.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Modes;

namespace {

constexpr std::size_t most_nodes = std::size_t{1} << 14;

const Game::Edge* edge_of(const SolvedGame& group) {
  const std::uint32_t edge = group.decision().edge;
  return edge == GameDecision::no_edge ? nullptr : &group.game->edges()[edge];
}

/// What may be seen of one group after the action: the nodes of its outcomes, and the present one where it may stay.
std::vector<std::uint32_t> seen_of(const SolvedGame& group) {
  std::vector<std::uint32_t> nodes;
  const Game::Edge* edge = edge_of(group);
  if (edge == nullptr || edge->waits) nodes.push_back(group.start);
  for (std::uint32_t o = 0; edge != nullptr && o < edge->count; ++o)
    nodes.push_back(group.game->outcomes()[edge->first + o].node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// What is done for the goal as a whole: to keep it only where all of it is kept.
GameDecision::Purpose purpose_of(const Strategist::Answer& answer) {
  using Purpose = GameDecision::Purpose;
  Purpose purpose = Purpose::keep;
  for (const SolvedGame& group : answer.groups) {
    const Purpose own = group.decision().purpose;
    if (own == Purpose::none || purpose == Purpose::none) {
      purpose = Purpose::none;
    } else if (own == Purpose::reach || purpose == Purpose::reach) {
      purpose = Purpose::reach;
    } else if (own == Purpose::hold) {
      purpose = Purpose::hold;
    }
  }
  return purpose;
}

/// Of components whose mode has timed exits, in order.
std::vector<Strategy::KnownAge> known_ages(const Strategist::Answer& answer, automata::Ticks unit) {
  std::map<ComponentId, Strategy::KnownAge> known;
  for (const SolvedGame& group : answer.groups) {
    const Game& game = *group.game;
    if (game.memory() == Game::Memory::modes) continue;
    const auto& components = game.arena().components();
    for (std::size_t i = 0; i < components.size(); ++i) {
      const Age& age = game.ages(group.start)[i];
      if (!game.arena().plant().has_timed_exit(components[i], game.position(group.start).modes[components[i].index()]))
        continue;
      known.try_emplace(components[i],
                        Strategy::KnownAge{components[i], {age.least * unit.count}, {age.most * unit.count}});
    }
  }
  std::vector<Strategy::KnownAge> result;
  result.reserve(known.size());
  for (const auto& [c, age] : known) result.push_back(age);
  return result;
}

}  // namespace

std::optional<Strategy> strategy_from(Strategist& strategist, const Modes& modes) {
  Strategy strategy;
  std::map<std::pair<Modes, StrategyPosition>, std::uint32_t> numbers;
  std::vector<StrategyPosition> positions;  // by node
  const auto number = [&](const Modes& of, const StrategyPosition& position) {
    const auto [at, fresh] = numbers.try_emplace({of, position}, static_cast<std::uint32_t>(strategy.nodes.size()));
    if (fresh) {
      strategy.nodes.emplace_back().modes = of;
      positions.push_back(position);
    }
    return at->second;
  };
  number(modes, {});
  for (std::uint32_t n = 0; n < strategy.nodes.size(); ++n) {
    const Modes now = strategy.nodes[n].modes;
    const Strategist::Answer answer = strategist.from(now, positions[n]);
    if (!answer.solved || strategy.nodes.size() > most_nodes) return std::nullopt;
    if (n == 0) {
      strategy.rank = answer.rank;
      strategy.lasts = answer.lasts;
      if (answer.groups.size() == 1 && answer.rank != Rank::none) strategy.cost = answer.groups.front().decision().cost;
    }
    const bool all_wait = std::all_of(answer.groups.begin(), answer.groups.end(),
                                      [](const SolvedGame& g) { return edge_of(g) == nullptr || edge_of(g)->waits; });
    strategy.best = strategy.best && answer.best;
    std::vector<Modes> seen{now};
    bool goal = std::all_of(answer.later.begin(), answer.later.end(),
                            [](const SolvedGame& g) { return g.game->position(g.start).goal; });
    for (const SolvedGame& group : answer.groups) {
      goal = goal && group.game->position(group.start).goal;
      const auto& components = group.game->arena().components();
      std::vector<Modes> more;
      for (const Modes& joint : seen) {
        for (const std::uint32_t node : seen_of(group)) {
          Modes& next = more.emplace_back(joint);
          const Modes& then = group.game->position(node).modes;
          for (const ComponentId c : components) {
            if (then[c.index()] != now[c.index()]) next[c.index()] = then[c.index()];
          }
        }
      }
      std::sort(more.begin(), more.end());
      more.erase(std::unique(more.begin(), more.end()), more.end());
      if (more.size() > most_nodes) return std::nullopt;
      seen = std::move(more);
    }
    const auto edges = strategist.edges(answer, now, answer.action);
    std::vector<Strategy::Edge> next;
    for (Modes& then : seen) {
      // What nothing changes stays in its node.
      if (then == now && all_wait) continue;
      const std::uint32_t target = number(then, edges ? edges->to(then) : StrategyPosition());
      next.push_back({std::move(then), target});
    }
    Strategy::Node& node = strategy.nodes[n];
    node.purpose = purpose_of(answer);
    node.ages = known_ages(answer, strategist.age_unit());
    node.action = answer.action;
    node.goal = goal;
    if (answer.rank != Rank::none) node.next = std::move(next);
  }
  return strategy;
}

}  // namespace rmpl::runtime
