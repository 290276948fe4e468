// What may end, and what may be marked.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/reachable_locations.hpp"

#include <algorithm>
#include <utility>

namespace rmpl::compiler {

using automata::LocationId;

Flow flow_of(const automata::Program& program, const FreedomOf& freedom) {
  Flow flow;
  for (const automata::Location& location : program.locations) {
    FlowLocation& made = flow.emplace_back();
    made.composite = location.composite;
    made.start = location.start;
    made.parent = location.parent;
    made.may_be_left = freedom(location.maintenance).may_fail;
    made.may_go_on = !location.has_goal() || made.may_be_left || freedom({true, goal_of(location)}).may_hold;
    auto& arcs = made.draws.emplace_back();
    for (const automata::Arc& arc : location.arcs) arcs.push_back({arc.target, freedom(arc.guard), &arc.guard});
  }
  return flow;
}

ReachableLocations::ReachableLocations(Flow flow, const std::vector<LocationId>& starts)
    : flow_(std::move(flow)),
      starts_(flow_.size()),
      entries_(flow_.size()),
      vanishes_(flow_.size(), false),
      reached_(flow_.size(), false) {
  for (std::size_t l = 0; l < flow_.size(); ++l) {
    for (const auto& arcs : flow_[l].draws) {
      for (const FlowArc& arc : arcs) add_entries(l, arc.target.index());
    }
    if (flow_[l].parent && flow_[l].start) starts_[flow_[l].parent->index()].push_back(l);
  }
  for (LocationId start : starts) {
    for (auto parent = flow_[start.index()].parent; parent; parent = flow_[parent->index()].parent) {
      entries_[parent->index()].push_back(start.index());
      start = *parent;
    }
  }
  // Children and what follows stand behind, so going backwards settles nearly all in the first round.
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t l = flow_.size(); l-- > 0;) changed = update_vanishing(l) || changed;
  }
  if (!flow_.empty()) mark(0);
  for (const LocationId start : starts) mark(start.index());
  while (!pending_.empty()) {
    const std::size_t l = pending_.back();
    pending_.pop_back();
    for (const std::size_t start : starts_[l]) mark(start);
    if (!may_leave(l)) continue;
    for (const LocationId passed : flow_[l].passed) mark(passed.index());
    for (const auto& arcs : flow_[l].draws) {
      for (const FlowArc& arc : arcs) {
        if (arc.guard.may_hold) mark(arc.target.index());
      }
    }
  }
}

/// An arc into the inside of composites that its source is not in marks them with nothing else.
void ReachableLocations::add_entries(std::size_t source, std::size_t target) {
  const auto holds_source = [&](std::size_t composite) {
    for (auto parent = flow_[source].parent; parent; parent = flow_[parent->index()].parent) {
      if (parent->index() == composite) return true;
    }
    return false;
  };
  for (auto parent = flow_[target].parent; parent; parent = flow_[parent->index()].parent) {
    if (holds_source(parent->index())) return;
    entries_[parent->index()].push_back(target);
    target = parent->index();
  }
}

bool ReachableLocations::may_end(LocationId composite) const {
  const auto& starts = starts_[composite.index()];
  const auto& entries = entries_[composite.index()];
  return std::any_of(entries.begin(), entries.end(), [&](std::size_t entry) { return vanishes_[entry]; }) ||
         flow_[composite.index()].may_be_left ||
         std::all_of(starts.begin(), starts.end(), [&](std::size_t start) { return vanishes_[start]; });
}

/// Whether the arcs of a location may be looked at: a composite has ended, a goal is achieved.
bool ReachableLocations::may_leave(std::size_t location) const {
  return flow_[location].composite ? may_end(LocationId(location)) : flow_[location].may_go_on;
}

bool ReachableLocations::update_vanishing(std::size_t location) {
  if (vanishes_[location] || !may_leave(location)) return false;
  const auto& draws = flow_[location].draws;
  vanishes_[location] = std::any_of(draws.begin(), draws.end(), [&](const auto& arcs) { return may_vanish(arcs); });
  return vanishes_[location];
}

/// Whether for some truth of the guards all targets of enabled arcs may vanish.
bool ReachableLocations::may_vanish(const std::vector<FlowArc>& arcs) const {
  // Each arc to what lasts has to be shut. Guards over the same constraint are of one mind; others are free.
  for (const FlowArc& arc : arcs) {
    if (vanishes_[arc.target.index()]) continue;
    if (!arc.guard.may_fail) return false;
    const auto opposite = [&](const FlowArc& other) {
      return !vanishes_[other.target.index()] && arc.condition != nullptr && other.condition != nullptr &&
             other.condition->constraint == arc.condition->constraint &&
             other.condition->entailed != arc.condition->entailed;
    };
    if (std::any_of(arcs.begin(), arcs.end(), opposite)) return false;
  }
  return true;
}

void ReachableLocations::mark(std::size_t location) {
  if (reached_[location]) return;
  reached_[location] = true;
  pending_.push_back(location);
  if (flow_[location].parent) mark(flow_[location].parent->index());
}

}  // namespace rmpl::compiler
