// Looks up answers about modes under a control action.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/decisions.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::verifier {

using automata::ControlAction;
using automata::Modes;

namespace {

constexpr std::size_t most_nodes = 1u << 12;
/// So many reasons are looked through, one by one, where the tree has no answer.
constexpr std::size_t most_reasons = 512;

std::uint32_t value_at(std::uint32_t position, const Modes& modes, const ControlAction& action) {
  return position < modes.size() ? modes[position].value : action[position - modes.size()].value;
}

}  // namespace

std::optional<std::uint32_t> Decisions::find(const Modes& modes, const ControlAction& action) {
  const Node* node = &nodes_.front();
  while (node->kind == Kind::test) {
    const std::uint32_t value = value_at(node->number, modes, action);
    if (value >= node->next.size() || node->next[value] == 0) break;
    node = &nodes_[node->next[value]];
  }
  if (node->kind == Kind::answer) return node->number;
  const auto holds = [&](const Reason& reason) {
    return std::all_of(reason.premises.begin(), reason.premises.end(),
                       [&](const Premise& p) { return value_at(p.position, modes, action) == p.value; });
  };
  const auto reason = std::find_if(reasons_.begin(), reasons_.end(), holds);
  if (reason == reasons_.end()) return std::nullopt;
  graft(modes, action, *reason);
  return reason->answer;
}

void Decisions::add(const Modes& modes, const ControlAction& action, const std::vector<Premise>& premises,
                    std::uint32_t answer) {
  const Reason reason{premises, answer};
  graft(modes, action, reason);
  if (reasons_.size() < most_reasons) reasons_.push_back(reason);
}

/// Adds the reason where the tree has no answer for these.
void Decisions::graft(const Modes& modes, const ControlAction& action, const Reason& reason) {
  if (nodes_.size() + reason.premises.size() >= most_nodes) return;
  std::vector<Premise> left = reason.premises;
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
  nodes_[node].number = reason.answer;
}

}  // namespace rmpl::verifier
