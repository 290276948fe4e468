// Cells of a program's clocks.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/clock_cells.hpp"

#include <algorithm>

#include "base/function_ref.hpp"

namespace rmpl::verifier {

using automata::ClockId;
using automata::Formula;
using automata::Location;
using automata::LocationId;
using automata::Ticks;

namespace {

void for_each_atom(const Formula& formula, base::FunctionRef<void(const Formula&)> visit) {
  if (formula.kind == Formula::Kind::clock) visit(formula);
  for (const Formula& operand : formula.operands) for_each_atom(operand, visit);
}

void for_each_atom(const Location& location, base::FunctionRef<void(const Formula&)> visit) {
  for_each_atom(location.maintenance.constraint, visit);
  for (const automata::Arc& arc : location.arcs) for_each_atom(arc.guard.constraint, visit);
}

/// Whether the atom is true at its constant as it is below; else it is there as it is above.
bool turns_after(automata::Comparison comparison) {
  switch (comparison) {
    case automata::Comparison::at_most:
    case automata::Comparison::greater:
      return true;
    case automata::Comparison::less:
    case automata::Comparison::at_least:
      return false;
  }
  return false;
}

}  // namespace

ClockCells::ClockCells(const automata::Program& program) {
  const auto collect = [&](const Formula& atom) {
    if (!atom.bound.is_infinite()) constants_.push_back(atom.bound);
  };
  for (const Location& location : program.locations) for_each_atom(location, collect);
  std::sort(constants_.begin(), constants_.end());
  constants_.erase(std::unique(constants_.begin(), constants_.end()), constants_.end());
  if (!constants_.empty() && constants_.front() == Ticks{0}) start_ = 2;

  begins_.assign(program.clocks.size(), std::vector<bool>(top() + 1, false));
  const auto mark = [&](const Formula& atom) {
    const auto at = std::lower_bound(constants_.begin(), constants_.end(), atom.bound);
    if (at == constants_.end()) return;
    const auto constant = static_cast<std::size_t>(at - constants_.begin());
    begins_[atom.clock.index()][2 * constant + (turns_after(atom.comparison) ? 2 : 1)] = true;
  };
  for (const Location& location : program.locations) for_each_atom(location, mark);
  find_reads(program);
}

// A location that is marked fully starts what it holds; one that is marked because something inside it is does not. So
// each is there twice: as itself, and, `count` further, marked fully; there what its own clocks read before is
// forgotten.
void ClockCells::find_reads(const automata::Program& program) {
  const std::size_t count = program.locations.size();
  std::vector<std::vector<std::size_t>> leads(2 * count);
  reads_.assign(2 * count, std::vector<bool>(program.clocks.size(), false));
  for (std::size_t l = 0; l < count; ++l) {
    const Location& location = program.locations[l];
    for_each_atom(location, [&](const Formula& atom) { reads_[l][atom.clock.index()] = true; });
    for (const automata::Arc& arc : location.arcs) leads[l].push_back(count + arc.target.index());
    leads[count + l].push_back(l);
    if (!location.parent) continue;
    leads[l].push_back(location.parent->index());
    if (location.start) leads[count + location.parent->index()].push_back(count + l);
  }
  std::vector<std::vector<bool>> forgets(2 * count, std::vector<bool>(program.clocks.size(), false));
  for (std::size_t l = 0; l < count; ++l) {
    for (const ClockId clock : program.locations[l].own_clocks) forgets[count + l][clock.index()] = true;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t l = 0; l < leads.size(); ++l) {
      for (const std::size_t next : leads[l]) {
        for (std::size_t c = 0; c < program.clocks.size(); ++c) {
          if (!reads_[next][c] || reads_[l][c] || forgets[l][c]) continue;
          reads_[l][c] = true;
          changed = true;
        }
      }
    }
  }
}

std::vector<bool> ClockCells::live(const automata::Marking& marking) const {
  std::vector<bool> result(begins_.size(), false);
  for (const LocationId location : marking) {
    for (std::size_t c = 0; c < result.size(); ++c) result[c] = result[c] || reads_[location.index()][c];
  }
  return result;
}

Cell ClockCells::around(std::span<const ClockId> clocks, std::uint32_t position) const {
  const auto begins = [&](std::uint32_t p) {
    return std::any_of(clocks.begin(), clocks.end(), [&](ClockId clock) { return begins_[clock.index()][p]; });
  };
  Cell cell{position, position};
  while (cell.first > start_ && !begins(cell.first)) --cell.first;
  while (cell.last < top() && !begins(cell.last + 1)) ++cell.last;
  return cell;
}

Ticks ClockCells::below(std::uint32_t position) const {
  if (position % 2 == 1) return constants_[position / 2];
  return position == 0 ? Ticks{0} : constants_[position / 2 - 1];
}

Ticks ClockCells::above(std::uint32_t position) const {
  return position == top() ? Ticks::infinite() : constants_[position / 2];
}

Interval ClockCells::units(const Cell& cell, const TimeModel& time) const {
  const bool open_below = cell.first % 2 == 0 && !time.is_dense();
  const bool open_above = cell.last % 2 == 0 && !time.is_dense();
  Interval result;
  result.lower = open_below ? time.more_than(below(cell.first)) : time.at_least(below(cell.first));
  const Ticks end = above(cell.last);
  if (!end.is_infinite()) result.upper = open_above ? time.at_least(end) - 1 : time.at_most(end);
  return result;
}

Ticks ClockCells::nearest(const Cell& cell, Ticks reading) const {
  const Ticks lowest = below(cell.first) + Ticks{cell.first % 2 == 0 ? 1 : 0};
  const Ticks end = above(cell.last);
  const Ticks highest = end.is_infinite() ? end : end - Ticks{cell.last % 2 == 0 ? 1 : 0};
  return std::clamp(reading, lowest, std::max(lowest, highest));
}

bool ClockCells::in_order(const Cell& earlier, const Cell& later) const {
  return above(earlier.last) > below(later.first);
}

}  // namespace rmpl::verifier
