// Arcs, starts of what is entered, and the ends of what everything in it has left.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/onward.hpp"

#include <algorithm>

namespace rmpl::compiler {

using automata::Arc;
using automata::Location;
using automata::LocationId;

bool repeats(const Location& location, LocationId id) {
  if (location.has_goal() || location.clock_start) return false;  // `repeat` leads back to one
  return std::any_of(location.arcs.begin(), location.arcs.end(),
                     [&](const Arc& arc) { return arc.target == id && arc.guard.is_trivial(); });
}

const std::vector<bool>& Onward::behind(LocationId location) {
  leave(location.index());
  return followed();
}

const std::vector<bool>& Onward::started_by(LocationId repeating) {
  for (auto in = program_.locations[repeating.index()].parent; in; in = program_.locations[in->index()].parent) {
    left_.insert(in->index());
  }
  for (const Arc& arc : program_.locations[repeating.index()].arcs) {
    if (arc.target != repeating) enter(arc.target.index());
  }
  return followed();
}

const std::vector<bool>& Onward::followed() {
  while (!pending_.empty()) {
    const std::size_t next = pending_.back();
    pending_.pop_back();
    leave(next);
  }
  return seen_;
}

void Onward::leave(std::size_t l) {
  // The end of a location may be the end of what it is in, and so on outwards.
  for (std::optional<std::size_t> at = l; at;) {
    for (const Arc& arc : program_.locations[*at].arcs) enter(arc.target.index());
    const auto parent = program_.locations[*at].parent;
    const bool ends = parent && reach_.may_end(*parent) && left_.insert(parent->index()).second;
    at = ends ? std::optional(parent->index()) : std::nullopt;
  }
}

void Onward::enter(std::size_t entered) {
  std::vector<std::size_t> entering{entered};
  while (!entering.empty()) {
    const std::size_t l = entering.back();
    entering.pop_back();
    const Location& location = program_.locations[l];
    const auto& own = location.own_clocks;
    if (seen_[l] || (clock_ && std::find(own.begin(), own.end(), *clock_) != own.end())) continue;
    seen_[l] = true;
    pending_.push_back(l);
    if (!location.composite) continue;
    for (std::size_t child = l + 1; child < program_.locations.size(); ++child) {
      const auto& parent = program_.locations[child].parent;
      if (!parent || parent->index() < l) break;
      if (parent->index() == l && program_.locations[child].start) entering.push_back(child);
    }
  }
}

}  // namespace rmpl::compiler
