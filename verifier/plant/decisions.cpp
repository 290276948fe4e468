// Decisions.
// SPDX-License-Identifier: MIT
#include "verifier/plant/decisions.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::verifier {

using automata::ControlAction;
using automata::Modes;

namespace {

constexpr std::size_t most_nodes = 1u << 12;

std::uint32_t value_at(std::uint32_t position, const Modes& modes, const ControlAction& action) {
  return position < modes.size() ? modes[position].value : action[position - modes.size()].value;
}

}  // namespace

std::optional<std::uint32_t> Decisions::find(const Modes& modes, const ControlAction& action) const {
  const Node* node = &nodes_.front();
  while (node->kind == Kind::test) {
    const std::uint32_t value = value_at(node->number, modes, action);
    if (value >= node->next.size() || node->next[value] == 0) return std::nullopt;
    node = &nodes_[node->next[value]];
  }
  return node->kind == Kind::answer ? std::optional(node->number) : std::nullopt;
}

void Decisions::add(const Modes& modes, const ControlAction& action, const std::vector<Premise>& premises,
                    std::uint32_t answer) {
  if (nodes_.size() + premises.size() >= most_nodes) return;
  std::vector<Premise> left = premises;
  std::size_t node = 0;
  const auto descend = [&] {
    const std::uint32_t position = nodes_[node].number;
    const std::uint32_t value = value_at(position, modes, action);
    if (value >= nodes_[node].next.size()) nodes_[node].next.resize(value + std::size_t{1}, 0);
    if (nodes_[node].next[value] == 0) {
      nodes_[node].next[value] = static_cast<std::uint32_t>(nodes_.size());
      nodes_.emplace_back();
    }
    node = nodes_[node].next[value];
    std::erase_if(left, [&](const Premise& premise) { return premise.position == position; });
  };
  while (nodes_[node].kind == Kind::test) descend();
  CHECK(nodes_[node].kind == Kind::open);
  while (!left.empty()) {
    nodes_[node].kind = Kind::test;
    nodes_[node].number = left.front().position;
    descend();
  }
  nodes_[node].kind = Kind::answer;
  nodes_[node].number = answer;
}

}  // namespace rmpl::verifier
