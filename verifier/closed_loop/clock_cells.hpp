// Cells of a program's clocks: stretches of readings that its clock atoms do not tell apart.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "automata/program.hpp"
#include "automata/step/program_step.hpp"
#include "verifier/zone/time_model.hpp"

namespace rmpl::verifier {

/// Adjacent positions. With the constants c0 < c1 < … of all clock atoms, position 0 is what lies below c0, 1 is c0
/// itself, 2 what lies between c0 and c1, and so on; the last one has no end.
struct Cell {
  std::uint32_t first, last;
  auto operator<=>(const Cell&) const = default;
};

/// The cells of a program. All of its clocks share one scale of positions, so that cells of different clocks compare.
class ClockCells {
 public:
  explicit ClockCells(const automata::Program& program);

  /// The finite constants of clock atoms, ascending.
  [[nodiscard]] const std::vector<automata::Ticks>& constants() const { return constants_; }
  /// Where a clock is when it is first read: it started a cycle ago, so that it reads more than 0.
  [[nodiscard]] std::uint32_t start() const { return start_; }
  /// The cell that holds a position, for clocks that read the same.
  [[nodiscard]] Cell around(std::span<const automata::ClockId> clocks, std::uint32_t position) const;
  /// Whether a clock that is in the cell stays there for ever.
  [[nodiscard]] bool is_last(const Cell& cell) const { return cell.last == top(); }

  /// The readings of the cell in whole units. Sampled: exactly they. Dense: with both ends, as a cycle just before or
  /// after a constant happens, in the limit, at the constant.
  [[nodiscard]] Interval units(const Cell& cell, const TimeModel& time) const;
  /// The reading in the cell that is nearest to the one given.
  [[nodiscard]] automata::Ticks nearest(const Cell& cell, automata::Ticks reading) const;
  /// Whether a clock in `earlier` can read more than one in `later`.
  [[nodiscard]] bool in_order(const Cell& earlier, const Cell& later) const;

  /// The clocks that a program may still read from a marking on, by `ClockId`.
  [[nodiscard]] std::vector<bool> live(const automata::Marking& marking) const;

 private:
  [[nodiscard]] std::uint32_t top() const { return 2 * static_cast<std::uint32_t>(constants_.size()); }
  /// The ends of a position, for an even one not included; infinite where it has no end.
  [[nodiscard]] automata::Ticks below(std::uint32_t position) const;
  [[nodiscard]] automata::Ticks above(std::uint32_t position) const;
  void find_reads(const automata::Program& program);

  std::vector<automata::Ticks> constants_;
  std::uint32_t start_ = 0;
  std::vector<std::vector<bool>> begins_;  ///< per clock, per position: some atom tells it from the one before
  std::vector<std::vector<bool>> reads_;   ///< per location, and again marked fully: the clocks that may be read
};

}  // namespace rmpl::verifier
