// What is expected of a game that is under way: of its strategy, or of a reward's.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/course.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace rmpl::runtime {

using automata::ComponentId;

std::vector<const Game::Outcome*> Course::outcomes(std::uint32_t n) const {
  std::uint32_t number = edge_number(n);
  // What is pursued for reward comes by itself in the end.
  const bool had = reward_ == nullptr || game_.position(n).reward >= reward_->pursued.reward;
  if (number == GameDecision::no_edge && !had && game_.nodes()[n].count > 0) number = game_.nodes()[n].first;
  if (number == GameDecision::no_edge) return {};
  const Game::Edge& taken = game_.edges()[number];
  using Key = std::tuple<std::size_t, bool, Rank, Cost, std::uint32_t>;
  std::vector<Key> keys;
  for (std::uint32_t o = taken.first; o < taken.first + taken.count; ++o) {
    const Game::Outcome& outcome = game_.outcomes()[o];
    std::size_t surprises = outcome.coincides ? 1 : 0;
    for (std::size_t m = 0; taken.waits && m < game_.arena().components().size(); ++m)
      surprises += mode(n, m) != mode(outcome.node, m) ? 1 : 0;
    Key key{surprises, false, Rank::sure, outcome.cost, o};
    if (solved_ != nullptr) {
      const GameDecision& then = solved_->solution->at(outcome.node);
      if (then.rank == Rank::none && solved_->decision().rank != Rank::none) continue;
      key = {surprises, !then.lasts, then.rank, outcome.cost + then.cost, o};
    }
    keys.push_back(std::move(key));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<const Game::Outcome*> result;
  result.reserve(keys.size());
  for (const Key& key : keys) result.push_back(&game_.outcomes()[std::get<4>(key)]);
  return result;
}

std::uint32_t Course::end() const {
  std::uint32_t n = start_;
  std::vector<bool> seen(game_.nodes().size());
  while (!seen[n]) {
    seen[n] = true;
    if (solved_ != nullptr && solved_->solution->at(n).purpose != GameDecision::Purpose::reach) break;
    const Game::Outcome* next = expected(n);
    if (next == nullptr) break;
    n = next->node;
  }
  return n;
}

std::size_t Course::open_part(const Strategist& strategist, std::optional<std::size_t> member) const {
  const auto& held = game_.arena().held(game_.nodes()[start_].position);
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i]) continue;
    if (!first) first = i;
    const auto& relevant = strategist.relevant(solved_->parts[i]);
    if (member && std::binary_search(relevant.begin(), relevant.end(), game_.arena().components()[*member])) return i;
  }
  return first.value_or(0);
}

const LocalMoves::Exit* exit_to(const Course& course, const Position::Action& action, std::size_t member,
                                std::uint32_t node) {
  for (const LocalMoves::Exit& exit : action.moves[member]->exits) {
    if (exit.to == course.mode(node, member)) return &exit;
  }
  return nullptr;
}

}  // namespace rmpl::runtime
