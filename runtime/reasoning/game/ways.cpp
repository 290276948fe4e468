// Minimal sets of commands, found by shrinking and leaving out.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/ways.hpp"

#include <algorithm>
#include <set>

namespace rmpl::runtime {

namespace {

/// As sorted lists of positions: the first difference decides, a prefix comes before what it begins.
bool comes_before(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t differ = a ^ b;
  if (differ == 0) return false;
  const std::uint64_t lowest = differ & (~differ + 1);
  // The list that has the lowest command goes on with it; the other one with a later one, if with any.
  const bool a_has = (a & lowest) != 0;
  const std::uint64_t rest = (a_has ? b : a) & ~(lowest - 1);
  return a_has == (rest != 0);
}

}  // namespace

int level_number(const Level& level) {
  switch (level.rank) {
    case Rank::sure:
      return level.lasts ? 0 : 2;
    case Rank::fair:
      return level.lasts ? 1 : 3;
    case Rank::hoped:
      return level.lasts ? 4 : 5;
    case Rank::none:
      break;
  }
  return 6;
}

Level best_level(Rank lasting, Rank passing) {
  if (lasting <= Rank::fair) return {lasting, true};
  if (passing <= Rank::fair || lasting == Rank::none) return {passing, false};
  return {lasting, true};
}

bool has_control(const automata::Component& component, automata::VariableId control) {
  const auto reads = [&](const automata::Formula& formula) {
    const std::vector<automata::VariableId> variables = variables_of(formula);
    return std::binary_search(variables.begin(), variables.end(), control);
  };
  return std::any_of(component.modes.begin(), component.modes.end(),
                     [&](const automata::Mode& m) { return reads(m.constraint); }) ||
         std::any_of(component.transitions.begin(), component.transitions.end(),
                     [&](const automata::Transition& t) { return reads(t.guard); });
}

GameWays::GameWays(const Game& game, const Backward& backward, std::uint32_t start)
    : game_(game), backward_(backward), start_(start), goal_(game.nodes().size()), off_(game.edges().size()) {
  std::set<std::pair<std::size_t, automata::ValueId>> all;
  for (std::uint32_t n = 0; n < game.nodes().size(); ++n) {
    goal_[n] = game.position(n).goal;
    for_each_command(n,
                     [&](std::uint32_t, std::size_t control, automata::ValueId value) { all.emplace(control, value); });
  }
  commands_.assign(all.begin(), all.end());
  if (!countable()) return;
  for (std::uint32_t n = 0; n < game.nodes().size(); ++n) {
    for_each_command(n, [&](std::uint32_t edge, std::size_t control, automata::ValueId value) {
      const auto at = std::lower_bound(commands_.begin(), commands_.end(), std::pair{control, value});
      off_[edge] |= std::uint64_t{1} << (at - commands_.begin());
    });
  }
}

template <class Visit>
void GameWays::for_each_command(std::uint32_t n, const Visit& visit) const {
  const Game::Node& node = game_.nodes()[n];
  if (node.count == 0) return;
  const auto& rest = game_.arena().action(game_.edges()[node.first].action);
  for (std::uint32_t e = node.first; e < node.first + node.count; ++e) {
    const auto& action = game_.arena().action(game_.edges()[e].action);
    for (const std::size_t i : game_.arena().controls()) {
      if (action[i] != rest[i]) visit(e, i, action[i]);
    }
  }
}

GameSet GameWays::permitted(std::uint64_t commands) const {
  GameSet result(off_.size());
  for (std::uint32_t e = 0; e < off_.size(); ++e) result[e] = game_.edges()[e].permitted && (off_[e] & ~commands) == 0;
  return result;
}

Level GameWays::level(std::uint64_t commands) const {
  const GameSet edges = permitted(commands);
  const GameSet kept = kept_nodes(game_, backward_, edges);
  const Rank lasting = Chain(game_, backward_, edges, kept, {}).at(start_).rank;
  // No rank towards the goal alone is better then.
  if (lasting <= Rank::fair) return {lasting, true};
  return best_level(lasting, Chain(game_, backward_, edges, goal_, {}).at(start_).rank);
}

bool GameWays::have(std::uint64_t commands, Level best) const {
  if (best != Level{Rank::sure, true}) return level(commands) == best;
  const GameSet edges = permitted(commands);
  return sure_nodes(game_, backward_, edges, kept_nodes(game_, backward_, edges))[start_];
}

/// Leaves out the last commands first, so that the way keeps those declared first.
std::uint64_t GameWays::shrink(std::uint64_t way, Level wanted) const {
  for (std::size_t i = commands_.size(); i-- > 0;) {
    const std::uint64_t bit = std::uint64_t{1} << i;
    if ((way & bit) != 0 && have(way & ~bit, wanted)) way &= ~bit;
  }
  return way;
}

std::vector<std::uint64_t> GameWays::find() const {
  constexpr std::size_t most_tries = 256;
  const std::size_t count = commands_.size();
  const std::uint64_t all = count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
  const Level wanted = level(all);
  std::vector<std::uint64_t> found, open{all};
  std::set<std::uint64_t> tried;
  while (!open.empty() && tried.size() < most_tries) {
    const std::uint64_t within = open.back();
    open.pop_back();
    if (!tried.insert(within).second) continue;
    // Every way that was found is minimal: within a set that has one of them there may be others.
    if (within != all && !have(within, wanted)) continue;
    const std::uint64_t way = shrink(within, wanted);
    if (std::find(found.begin(), found.end(), way) == found.end()) found.push_back(way);
    // Another way leaves out some command of this one.
    for (std::size_t i = count; i-- > 0;) {
      if ((way >> i & 1) != 0) open.push_back(within & ~(std::uint64_t{1} << i));
    }
  }
  std::sort(found.begin(), found.end(), comes_before);
  return found;
}

std::vector<GameWays::Command> GameWays::commands(std::uint64_t way) const {
  std::vector<Command> result;
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    if ((way >> i & 1) != 0) result.push_back(commands_[i]);
  }
  return result;
}

std::vector<bool> GameWays::moved(std::uint64_t way) const {
  const auto& components = game_.arena().components();
  const GameSet usable = permitted(way);
  const auto& start = game_.position(start_).modes;
  GameSet result(components.size()), seen(game_.nodes().size());
  std::vector<std::uint32_t> open{start_};
  seen[start_] = true;
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    const auto& modes = game_.position(n).modes;
    for (std::size_t i = 0; i < components.size(); ++i) {
      if (modes[components[i].index()] != start[components[i].index()]) result[i] = true;
    }
    const Game::Node& node = game_.nodes()[n];
    for (std::uint32_t e = node.first; e < node.first + node.count; ++e) {
      if (!usable[e]) continue;
      const Game::Edge& edge = game_.edges()[e];
      for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
        const std::uint32_t then = game_.outcomes()[o].node;
        if (seen[then]) continue;
        seen[then] = true;
        open.push_back(then);
      }
    }
  }
  return result;
}

std::vector<bool> GameWays::counted(std::uint64_t way) const {
  const Arena& arena = game_.arena();
  std::vector<bool> result = moved(way);
  const std::vector<bool> anyway = moved(0);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = result[i] && !anyway[i];
    for (std::size_t bit = 0; bit < commands_.size(); ++bit) {
      const auto variable = arena.plant().controls[commands_[bit].first].variable;
      if ((way >> bit & 1) != 0 && has_control(arena.plant()[arena.components()[i]], variable)) result[i] = true;
    }
  }
  return result;
}

}  // namespace rmpl::runtime
