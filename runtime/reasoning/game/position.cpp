// Positions as values, and the edges between them.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/position.hpp"

#include <algorithm>
#include <functional>

#include "base/hash.hpp"

namespace rmpl::runtime {

StrategyPosition::StrategyPosition(std::string goal, std::vector<Group> groups) {
  if (!groups.empty()) data_ = std::make_shared<const Data>(Data{std::move(goal), std::move(groups)});
}

const std::vector<StrategyPosition::Group>& StrategyPosition::groups(const std::string& goal) const {
  static const std::vector<Group> nothing;
  return data_ != nullptr && data_->goal == goal ? data_->groups : nothing;
}

std::strong_ordering StrategyPosition::operator<=>(const StrategyPosition& other) const {
  if (data_ == other.data_) return std::strong_ordering::equal;
  if (data_ == nullptr || other.data_ == nullptr) return (data_ != nullptr) <=> (other.data_ != nullptr);
  return *data_ <=> *other.data_;
}

std::size_t StrategyPosition::hash() const {
  if (data_ == nullptr) return 0;
  std::uint64_t hash = base::mix(base::hash_seed, std::hash<std::string>()(data_->goal));
  for (const Group& group : data_->groups) {
    hash = base::mix_ids(hash, group.components);
    for (const Age& age : group.ages) {
      hash = base::mix(hash, static_cast<std::uint64_t>(age.least));
      hash = base::mix(hash, static_cast<std::uint64_t>(age.most));
    }
  }
  return hash;
}

StrategyPosition StrategyEdges::to(const automata::Modes& modes) const {
  std::vector<StrategyPosition::Group> groups;
  for (const Group& group : groups_) {
    const bool holds = std::all_of(group.context.begin(), group.context.end(),
                                   [&](const auto& held) { return modes[held.first.index()] == held.second; });
    if (!holds) continue;
    const auto fits = [&](const Group::Edge& edge) {
      for (std::size_t i = 0; i < group.components.size(); ++i) {
        if (modes[group.components[i].index()] != edge.modes[i]) return false;
      }
      return true;
    };
    const auto edge = std::find_if(group.edges.begin(), group.edges.end(), fits);
    if (edge != group.edges.end()) groups.push_back({group.parts, group.components, edge->ages});
  }
  return {goal_, std::move(groups)};
}

}  // namespace rmpl::runtime
