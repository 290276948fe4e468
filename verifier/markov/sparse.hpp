// Sparse matrices of bounds: powers of what one step does.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "verifier/markov/enclosure.hpp"
#include "verifier/search/limits.hpp"

namespace rmpl::verifier {

/// Row by row: columns ascending, each once.
class SparseMatrix {
 public:
  using Entry = std::pair<std::uint32_t, Enclosure>;
  using SparseRow = std::vector<Entry>;

  explicit SparseMatrix(std::vector<SparseRow> rows);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] std::size_t entries() const { return entries_; }
  [[nodiscard]] const SparseRow& row(std::size_t at) const { return rows_[at]; }
  /// How many products `squared` sums up.
  [[nodiscard]] std::size_t square_cost() const;
  [[nodiscard]] SparseMatrix squared(Meter& meter) const;
  /// A row vector times the matrix.
  [[nodiscard]] std::vector<Enclosure> from_left(const std::vector<Enclosure>& vector) const;

 private:
  std::vector<SparseRow> rows_;
  std::size_t entries_ = 0;
};

/// A row vector, which sums to 1 at most, times the matrix to that power, from 0. What is less likely than `ignored`
/// may go to the last state instead, of which only the upper bound counts.
///
/// Where states are seldom left, the number of times that they are is binomial, and it takes as many products as there
/// are likely such numbers, however many steps there are (uniformisation, as A. Jensen, 1953, has it of dense time).
/// Else the matrix is squared as long as that is less work than what is left of the steps: O(log steps) products where
/// squares stay sparse, as where few states follow each other.
std::vector<Enclosure> after_steps(std::vector<Enclosure> vector, SparseMatrix matrix, std::uint64_t steps,
                                   Real ignored, Meter& meter);

}  // namespace rmpl::verifier
