// Which steps cannot be undone. SPDX-License-Identifier: MIT
#include "tests/reference/game_rules.hpp"

#include <algorithm>
#include <map>

#include "tests/reference/goals.hpp"

namespace rmpl::reference {

using automata::ModeId;
using automata::Transition;

namespace {

using Graph = std::map<ModeId, std::set<ModeId>>;

std::set<ModeId> closure(const Graph& graph, std::set<ModeId> reached) {
  std::vector<ModeId> open(reached.begin(), reached.end());
  while (!open.empty()) {
    const ModeId from = open.back();
    open.pop_back();
    if (const auto next = graph.find(from); next != graph.end())
      for (const ModeId to : next->second)
        if (reached.insert(to).second) open.push_back(to);
  }
  return reached;
}

bool meet(const std::set<ModeId>& a, const std::set<ModeId>& b) {
  return std::any_of(a.begin(), a.end(), [&](ModeId m) { return b.contains(m); });
}

/// The usual modes from which a fault leads, at once or through modes after a fault, to `mode`, which is after a fault.
std::set<ModeId> entries(const Graph& all, const std::set<ModeId>& usual, ModeId mode) {
  Graph after_faults;
  for (const auto& [from, targets] : all)
    if (!usual.contains(from)) after_faults[from] = targets;
  std::set<ModeId> result;
  for (const auto& [from, targets] : all) {
    if (!usual.contains(from)) continue;
    for (const ModeId to : targets)
      if (!usual.contains(to) && closure(after_faults, {to}).contains(mode)) result.insert(from);
  }
  return result;
}

}  // namespace

Irreversible::Irreversible(GameStep& step, const automata::Formula& goal, const std::set<std::size_t>& progress) {
  for (std::size_t c = 0; c < step.plant().components.size(); ++c) {
    const automata::Component& component = step.plant().components[c];
    Graph nominal;
    Graph all;
    for (const Transition& t : component.transitions) {
      if (!step.can_be_taken(c, t)) continue;
      all[t.from].insert(t.to);
      if (!component.is_fault(t)) nominal[t.from].insert(t.to);
    }
    std::set<ModeId> starts;
    for (std::size_t m = 0; m < component.modes.size(); ++m)
      if (component.initial[m] > 0 && !component.modes[m].fault) starts.insert(ModeId(m));
    const std::set<ModeId> usual = closure(nominal, starts);
    auto& steps = steps_.emplace_back();
    for (const auto& [from, targets] : nominal) {
      const bool after_fault =
          component.modes[from.index()].fault || (!usual.contains(from) && closure(all, starts).contains(from));
      const std::set<ModeId> back = after_fault ? entries(all, usual, from) : std::set{from};
      for (const ModeId to : targets)
        if (to != from && !back.empty() && !meet(closure(nominal, {to}), back) && !progress.contains(c))
          steps.emplace(from, to);
    }
    auto& licensed = licensed_.emplace_back();
    const std::set<ModeId> named = named_modes(step.plant(), c, goal);
    for (std::size_t m = 0; m < component.modes.size(); ++m)
      if (meet(closure(nominal, {ModeId(m)}), named)) licensed.insert(ModeId(m));
  }
}

}  // namespace rmpl::reference
