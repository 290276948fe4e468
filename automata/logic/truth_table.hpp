// Where something holds, told row by row, as a short formula.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "automata/logic/formula.hpp"

namespace rmpl::automata {

/// A function of some variables with two values. Rows that are never added are not asked for: what comes out there is
/// left open, and chosen as it makes the formula short.
class TruthTable {
 public:
  explicit TruthTable(std::vector<VariableId> columns) : columns_(std::move(columns)) {}

  /// The values are those of the columns, in their order. Each row is added once.
  void add(std::vector<ValueId> values, bool holds) { rows_.emplace_back(std::move(values), holds); }
  /// The formula that holds where the rows do: over columns that decide something, values that do the same told
  /// together. Quadratic in the rows, at worst.
  [[nodiscard]] Formula formula() const;

 private:
  std::vector<VariableId> columns_;
  std::vector<std::pair<std::vector<ValueId>, bool>> rows_;
};

}  // namespace rmpl::automata
