// What may end, and what may be marked.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/reachable_locations.hpp"

#include <algorithm>

namespace rmpl::compiler {

using automata::Arc;
using automata::Condition;
using automata::Location;

ReachableLocations::ReachableLocations(const automata::Program& program, const FreedomOf& freedom)
    : program_(program),
      starts_(program.locations.size()),
      entries_(program.locations.size()),
      vanishes_(program.locations.size(), false),
      reached_(program.locations.size(), false) {
  const auto& locations = program.locations;
  for (std::size_t l = 0; l < locations.size(); ++l) {
    auto& guards = guards_.emplace_back();
    for (const Arc& arc : locations[l].arcs) {
      guards.push_back(freedom(arc.guard));
      add_entries(l, arc.target.index());
    }
    maintenance_.push_back(freedom(locations[l].maintenance));
    goals_.push_back(freedom({true, conjunction_of(locations[l].goal)}));
    if (locations[l].parent && locations[l].start) starts_[locations[l].parent->index()].push_back(l);
  }
  // Children and what follows stand behind, so going backwards settles nearly all in the first round.
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t l = locations.size(); l-- > 0;) changed = update_vanishing(l) || changed;
  }
  if (!locations.empty()) mark(0);
  while (!pending_.empty()) {
    const std::size_t l = pending_.back();
    pending_.pop_back();
    for (const std::size_t start : starts_[l]) mark(start);
    if (!may_leave(l)) continue;
    for (std::size_t a = 0; a < locations[l].arcs.size(); ++a) {
      if (guards_[l][a].may_hold) mark(locations[l].arcs[a].target.index());
    }
  }
}

/// An arc into the inside of composites that its source is not in marks them with nothing else.
void ReachableLocations::add_entries(std::size_t source, std::size_t target) {
  const auto& locations = program_.locations;
  const auto holds_source = [&](std::size_t composite) {
    for (auto parent = locations[source].parent; parent; parent = locations[parent->index()].parent) {
      if (parent->index() == composite) return true;
    }
    return false;
  };
  for (auto parent = locations[target].parent; parent; parent = locations[parent->index()].parent) {
    if (holds_source(parent->index())) return;
    entries_[parent->index()].push_back(target);
    target = parent->index();
  }
}

bool ReachableLocations::may_end(automata::LocationId composite) const {
  const auto& starts = starts_[composite.index()];
  const auto& entries = entries_[composite.index()];
  return std::any_of(entries.begin(), entries.end(), [&](std::size_t entry) { return vanishes_[entry]; }) ||
         maintenance_[composite.index()].may_fail ||
         std::all_of(starts.begin(), starts.end(), [&](std::size_t start) { return vanishes_[start]; });
}

/// Whether the arcs of a location may be looked at: a composite has ended, a goal is achieved.
bool ReachableLocations::may_leave(std::size_t location) const {
  const Location& l = program_.locations[location];
  if (l.composite) return may_end(automata::LocationId(location));
  return l.goal.empty() || goals_[location].may_hold || maintenance_[location].may_fail;
}

bool ReachableLocations::update_vanishing(std::size_t location) {
  if (vanishes_[location] || !may_leave(location)) return false;
  vanishes_[location] = arcs_may_vanish(location);
  return vanishes_[location];
}

/// Whether for some truth of the guards all targets of enabled arcs may vanish.
bool ReachableLocations::arcs_may_vanish(std::size_t location) const {
  const std::vector<Arc>& arcs = program_.locations[location].arcs;
  // Each arc to what lasts has to be shut. Guards over the same constraint are of one mind; others are free.
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    if (vanishes_[arcs[a].target.index()]) continue;
    if (!guards_[location][a].may_fail) return false;
    const auto opposite = [&](const Arc& other) {
      return !vanishes_[other.target.index()] && other.guard.constraint == arcs[a].guard.constraint &&
             other.guard.entailed != arcs[a].guard.entailed;
    };
    if (std::any_of(arcs.begin(), arcs.end(), opposite)) return false;
  }
  return true;
}

void ReachableLocations::mark(std::size_t location) {
  if (reached_[location]) return;
  reached_[location] = true;
  pending_.push_back(location);
  if (program_.locations[location].parent) mark(program_.locations[location].parent->index());
}

}  // namespace rmpl::compiler
