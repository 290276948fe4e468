// The game cycle by cycle. SPDX-License-Identifier: MIT
#include "tests/reference/game_ticks.hpp"

#include <algorithm>
#include <set>

#include "tests/reference/models.hpp"

namespace rmpl::reference {

using automata::ModeId;
using automata::Modes;
using automata::Transition;

Node TickArena::number(std::pair<Modes, Ages> key) {
  for (std::size_t c = 0; c < key.first.size(); ++c)
    key.second[c] = std::min(key.second[c], age_that_matters(step().plant().components[c], key.first[c], cycle_));
  const auto [at, fresh] = numbers_.try_emplace(std::move(key), nodes_.size());
  if (fresh) nodes_.push_back(&at->first);
  return at->second;
}

std::optional<Turn> TickArena::turn(Node node, GameStep::Action action) {
  const auto from = *nodes_[node];
  const auto& freedom = step().freedom(from.first, action);
  if (!freedom) return std::nullopt;
  std::vector<std::vector<std::pair<ModeId, const Transition*>>> options;
  std::vector<std::size_t> sizes;
  for (std::size_t c = 0; c < from.first.size(); ++c) {
    const Freedom& own = (*freedom)[c];
    const std::int64_t age = from.second[c] + 1;
    const std::int64_t due = first_due(own, cycle_);
    auto& choices = options.emplace_back();
    for (const ModeId to : own.at_once) choices.emplace_back(to, nullptr);
    if (choices.empty() && age < due) choices.emplace_back(from.first[c], nullptr);
    for (const Transition* t : own.timed) {
      const Window window = window_of(*t->timing, cycle_);
      if (age < due ? age >= window.first : age >= window.last) choices.emplace_back(t->to, t);
    }
    sizes.push_back(choices.size());
  }
  Turn turn;
  std::set<Nogood> contradicted;
  for (const auto& tuple : tuples(sizes)) {
    auto next = from;
    Result result{};
    for (std::size_t c = 0; c < tuple.size(); ++c) {
      const auto& [to, timed] = options[c][tuple[c]];
      next.second[c] = to == from.first[c] && !(*freedom)[c].restarts ? next.second[c] + 1 : 0;
      next.first[c] = to;
      if (timed != nullptr) result.chosen.emplace_back(c, timed->branch);
    }
    const auto& nogoods = step().nogoods(next.first);
    contradicted.insert(nogoods.begin(), nogoods.end());
    if (!nogoods.empty()) continue;
    result.to = number(std::move(next));
    result.soonest = cycle_;
    result.latest = {0, cycle_};
    turn.results.push_back(std::move(result));
  }
  turn.contradicted.assign(contradicted.begin(), contradicted.end());
  turn.dead = turn.results.empty();
  return turn;
}

}  // namespace rmpl::reference
