// Backwards from goals, through arcs and the ends of composites.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/goal_threads.hpp"

#include <algorithm>
#include <functional>

namespace rmpl::compiler {

using automata::Formula;
using automata::Location;

namespace {

/// Adds what leads to what is relevant, until there is no more.
void close(const automata::Program& program, std::vector<bool>& relevant) {
  const auto& locations = program.locations;
  // By its end: what follows a composite waits for all that it holds.
  std::vector<bool> by_end(locations.size(), false);
  for (bool changed = true; changed;) {
    changed = false;
    const auto set = [&](std::vector<bool>& flags, std::size_t l) {
      if (flags[l]) return;
      flags[l] = true;
      changed = true;
    };
    for (std::size_t l = locations.size(); l-- > 0;) {
      const Location& location = locations[l];
      const auto leads = [&](const automata::Arc& arc) { return relevant[arc.target.index()]; };
      const bool onward = std::any_of(location.arcs.begin(), location.arcs.end(), leads);
      const bool parent_waits = location.parent && by_end[location.parent->index()];
      if (location.composite && (onward || parent_waits)) set(by_end, l);
      if (onward || parent_waits) set(relevant, l);
      if (relevant[l] && location.parent) set(relevant, location.parent->index());
    }
  }
}

void collect_clocks(const Formula& formula, std::vector<bool>& read) {
  if (formula.kind == Formula::Kind::clock) read[formula.clock.index()] = true;
  for (const Formula& operand : formula.operands) collect_clocks(operand, read);
}

}  // namespace

std::vector<bool> goal_threads(const automata::Program& program, automata::VariableId component) {
  const auto& locations = program.locations;
  std::vector<bool> relevant(locations.size(), false);
  for (std::size_t l = 0; l < locations.size(); ++l) {
    relevant[l] = std::any_of(locations[l].goal.begin(), locations[l].goal.end(),
                              [&](const automata::Assignment& goal) { return goal.variable == component; });
  }
  for (bool changed = true; changed;) {
    changed = false;
    close(program, relevant);
    std::vector<bool> read(program.clocks.size(), false);
    for (std::size_t l = 0; l < locations.size(); ++l) {
      if (!relevant[l]) continue;
      collect_clocks(locations[l].maintenance.constraint, read);
      for (const automata::Arc& arc : locations[l].arcs) collect_clocks(arc.guard.constraint, read);
    }
    for (std::size_t l = 0; l < locations.size(); ++l) {
      if (relevant[l] || !locations[l].clock_start || !read[locations[l].clock_start->index()]) continue;
      relevant[l] = changed = true;
    }
  }
  return relevant;
}

}  // namespace rmpl::compiler
