// Rewards where the goal is kept. SPDX-License-Identifier: MIT
#include "tests/reference/game_pursuit.hpp"

#include <algorithm>
#include <functional>
#include <vector>

namespace rmpl::reference {

Pursuit::Pursuit(Board& board, const std::set<Node>& kept, Node start)
    : board_(board), kept_(kept), start_(start), restful_(kept) {
  for (std::size_t before = restful_.size() + 1; before != restful_.size();) {
    before = restful_.size();
    std::erase_if(restful_, [&](Node node) {
      const Option* option = rest(node);
      return option == nullptr || !std::all_of(option->ways.begin(), option->ways.end(),
                                               [&](const Option::Way& way) { return restful_.contains(way.to); });
    });
  }
  idle_ = value(start);
  if (!kept.contains(start)) return;
  const std::set<Node> all = reached();
  std::set<double, std::greater<>> rewards;
  for (const Node node : all)
    if (restful_.contains(node)) rewards.insert(value(node));
  for (const double reward : rewards) {
    if (reward <= idle_) return;
    solve(all, reward);
    if (!states_.contains(start)) continue;
    reward_ = reward;
    return;
  }
}

const Option* Pursuit::rest(Node node) const {
  for (const Option& option : board_.options(node))
    if (option.commands.front().empty()) return &option;
  return nullptr;
}

/// All that idling leads to, the node included.
std::set<Node> Pursuit::rested(Node node) const {
  std::set<Node> result{node};
  std::vector<Node> open{node};
  while (!open.empty()) {
    const Option* option = rest(open.back());
    open.pop_back();
    if (option == nullptr) continue;
    for (const Option::Way& way : option->ways)
      if (result.insert(way.to).second) open.push_back(way.to);
  }
  return result;
}

double Pursuit::value(Node node) const {
  std::optional<double> least;
  for (const Node later : rested(node)) {
    const std::set<Node> from_there = rested(later);
    const bool for_ever =
        std::all_of(from_there.begin(), from_there.end(), [&](Node last) { return rested(last).contains(later); });
    if (!for_ever) continue;
    double total = 0;
    for (std::size_t c = 0; c < board_.arena().modes(later).size(); ++c) total += board_.reward(later, c);
    if (!least || total < *least) least = total;
  }
  return *least;
}

bool Pursuit::may(const Option& option) const {
  const bool stays = std::all_of(option.ways.begin(), option.ways.end(),
                                 [&](const Option::Way& way) { return kept_.contains(way.to) && !way.irreversible; });
  return stays && !option.ways.empty() && option.ends;
}

/// All that such options lead to.
std::set<Node> Pursuit::reached() const {
  std::set<Node> result{start_};
  std::vector<Node> open{start_};
  while (!open.empty()) {
    const Node node = open.back();
    open.pop_back();
    for (const Option& option : board_.options(node)) {
      if (!may(option)) continue;
      for (const Option::Way& way : option.ways)
        if (result.insert(way.to).second) open.push_back(way.to);
    }
  }
  return result;
}

void Pursuit::solve(const std::set<Node>& nodes, double reward) {
  states_.clear();
  for (const Node node : nodes)
    if (restful_.contains(node) && value(node) >= reward) states_.emplace(node, State{});
  const std::map<Node, State> had = states_;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Node node : nodes) {
      if (had.contains(node)) continue;
      for (const Option& option : board_.options(node)) {
        if (!may(option)) continue;
        std::optional<GameCost> worst = GameCost{};
        for (const Option::Way& way : option.ways) {
          const auto next = states_.find(way.to);
          if (next == states_.end()) worst.reset();
          if (!worst) break;
          worst = std::max(*worst, way.cost + next->second.cost,
                           [](const GameCost& a, const GameCost& b) { return a < b; });
        }
        const auto known = states_.find(node);
        if (!worst || (known != states_.end() && !(*worst < known->second.cost))) continue;
        states_.insert_or_assign(node, State{*worst, &option});
        changed = true;
      }
    }
  }
}

}  // namespace rmpl::reference
