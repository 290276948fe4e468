// The fixpoints of the game. SPDX-License-Identifier: MIT
#include "tests/reference/game_solve.hpp"

#include <algorithm>

namespace rmpl::reference {

namespace {

template <class Nodes>
bool stays(const Option& option, const Nodes& nodes) {
  return std::all_of(option.ways.begin(), option.ways.end(),
                     [&](const Option::Way& way) { return nodes.contains(way.to); });
}

/// Whether chance may lead to some of the nodes, whatever nature chooses.
template <class Nodes>
bool may_come(const Option& option, const Nodes& nodes) {
  std::map<std::size_t, bool> met;  // by what nature chose
  for (const Option::Way& way : option.ways) met[way.chosen] = met[way.chosen] || nodes.contains(way.to);
  return !met.empty() && std::all_of(met.begin(), met.end(), [](const auto& choice) { return choice.second; });
}

}  // namespace

namespace {

/// Takes away nodes that no action keeps in the set.
void shrink(std::set<Node>& set, Board& board, const May& may) {
  for (std::size_t before = set.size() + 1; before != set.size();) {
    before = set.size();
    std::erase_if(set, [&](Node node) {
      const auto& options = board.options(node);
      return std::none_of(options.begin(), options.end(),
                          [&](const Option& option) { return may(node, option) && stays(option, set); });
    });
  }
}

/// The nodes of the set from which some actions surely lead to a wait in it.
std::set<Node> that_come_to_a_wait(const std::set<Node>& set, Board& board, const May& may) {
  std::set<Node> result;
  for (bool more = true; more;) {
    const std::size_t before = result.size();
    for (const Node node : set) {
      const auto& options = board.options(node);
      const auto leads = [&](const Option& option) {
        return may(node, option) && stays(option, set) && (option.waits || stays(option, result));
      };
      if (std::any_of(options.begin(), options.end(), leads)) result.insert(node);
    }
    more = result.size() > before;
  }
  return result;
}

}  // namespace

std::set<Node> kept(Board& board, const May& may) {
  std::set<Node> result;
  for (const auto& [node, options] : board.nodes())
    if (board.holds(node)) result.insert(node);
  shrink(result, board, may);
  if (board.arena().actions_take_time()) return result;
  for (std::size_t before = result.size() + 1; before != result.size();) {
    before = result.size();
    result = that_come_to_a_wait(result, board, may);
    shrink(result, board, may);
  }
  return result;
}

namespace {

/// The least set with the target that holds each node of which some action counts by what is in it.
template <class Counts>
std::set<Node> least_set(const Board& board, const std::set<Node>& target, const May& may, const Counts& counts) {
  std::set<Node> result = target;
  for (std::size_t before = 0; before != result.size();) {
    before = result.size();
    for (const auto& [node, options] : board.nodes())
      if (std::any_of(options.begin(), options.end(),
                      [&, &from = node](const Option& option) { return may(from, option) && counts(option, result); }))
        result.insert(node);
  }
  return result;
}

std::set<Node> fair_nodes(const Board& board, const std::set<Node>& target, const May& may) {
  std::set<Node> outer;
  for (const auto& [node, options] : board.nodes()) outer.insert(node);
  for (std::size_t before = outer.size() + 1; before != outer.size();) {
    before = outer.size();
    outer = least_set(board, target, may, [&](const Option& option, const std::set<Node>& inner) {
      return stays(option, outer) && may_come(option, inner);
    });
  }
  return outer;
}

}  // namespace

Rank rank_of(const Board& board, Node node, const std::set<Node>& target, const May& may) {
  const auto surely = [](const Option& option, const std::set<Node>& nodes) {
    return !option.ways.empty() && option.ends && stays(option, nodes);
  };
  const auto perhaps = [](const Option& option, const std::set<Node>& nodes) {
    return std::any_of(option.ways.begin(), option.ways.end(),
                       [&](const Option::Way& way) { return nodes.contains(way.to); });
  };
  if (least_set(board, target, may, surely).contains(node)) return Rank::sure;
  if (fair_nodes(board, target, may).contains(node)) return Rank::fair;
  return least_set(board, target, may, perhaps).contains(node) ? Rank::hoped : Rank::none;
}

Chain::Chain(const Board& board, const std::set<Node>& target, const std::function<GameCost(Node)>& terminal,
             const May& may)
    : board_(board), may_(may) {
  for (const Node node : target) states_.emplace(node, State{Rank::sure, terminal(node)});
  std::set<Node> all;
  for (const auto& [node, options] : board.nodes()) all.insert(node);
  solve(Rank::sure, all);
  solve(Rank::fair, fair_nodes(board, target, may));
  solve(Rank::hoped, all);
}

Rank Chain::rank(Node node) const {
  const auto at = states_.find(node);
  return at == states_.end() ? Rank::none : at->second.rank;
}

/// What an action costs from here on, by what is known so far; nothing where it does not count for the rank.
std::optional<GameCost> Chain::cost(Rank rank, const Option& option, const std::set<Node>& within) const {
  if (option.ways.empty() || (rank != Rank::hoped && !stays(option, within))) return std::nullopt;
  if (rank == Rank::sure && !option.ends) return std::nullopt;
  std::map<std::size_t, std::optional<GameCost>> choices;
  for (std::size_t i = 0; i < option.ways.size(); ++i) {
    const Option::Way& way = option.ways[i];
    // Each way is a choice of its own to a sure strategy, and all are one to hope.
    std::size_t choice = 0;
    if (rank == Rank::sure) choice = i;
    if (rank == Rank::fair) choice = way.chosen;
    std::optional<GameCost>& best = choices[choice];
    const auto known = states_.find(way.to);
    if (known == states_.end()) continue;
    GameCost cost = way.cost + known->second.cost;
    cost.time.unbounded += rank == Rank::hoped && way.coincides ? 1 : 0;
    if (!best || cost < *best) best = cost;
  }
  std::optional<GameCost> worst;
  for (const auto& [choice, best] : choices) {
    if (!best) return std::nullopt;
    if (!worst || *worst < *best) worst = best;
  }
  return worst;
}

/// Until nothing costs less any more; what has a rank already stays as it is.
void Chain::solve(Rank rank, const std::set<Node>& within) {
  std::set<Node> open;
  for (const Node node : within)
    if (!states_.contains(node)) open.insert(node);
  for (bool changed = true; changed;) {
    changed = false;
    for (const Node node : open) {
      for (const Option& option : board_.options(node)) {
        if (!may_(node, option)) continue;
        const std::optional<GameCost> found = cost(rank, option, within);
        const auto known = states_.find(node);
        if (!found || (known != states_.end() && !(*found < known->second.cost))) continue;
        states_.insert_or_assign(node, State{rank, *found, &option});
        changed = true;
      }
    }
  }
  // Of equal ones what does something now goes before what waits, then the first.
  for (const Node node : open) {
    const auto known = states_.find(node);
    if (known == states_.end()) continue;
    for (const Option& option : board_.options(node)) {
      const auto found = may_(node, option) ? cost(rank, option, within) : std::nullopt;
      if (!found || *found != known->second.cost) continue;
      const Option*& best = known->second.option;
      if (std::pair(option.waits, option.action) < std::pair(best->waits, best->action)) best = &option;
    }
  }
}

}  // namespace rmpl::reference
