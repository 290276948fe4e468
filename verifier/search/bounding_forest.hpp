// Rows of numbers in boxes within boxes, so that those which may bound a new one from above or below are found without
// looking at all of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/function_ref.hpp"
#include "verifier/zone/interval.hpp"

namespace rmpl::verifier {

/// A k-d tree that grows (J. L. Bentley, J. B. Saxe: Decomposable Searching Problems, 1980): a forest of trees of 16,
/// 32, 64 … items, of which two of one size are built anew as one, and fewer than 16 items that wait for a tree. A
/// tree halves its items where their rows differ most, down to leaves of 16; each branch knows the greatest and the
/// least of every entry in it. So n items cost O(n log² n) in all, and a question looks into those branches alone that
/// may hold an answer.
///
/// Items are numbers whose rows the owner keeps.
class BoundingForest {
 public:
  /// Writes the row of an item; false where the item is not asked for any more, and leaves.
  using Row = base::FunctionRef<bool(std::uint32_t item, std::span<Units> row)>;
  /// Whether a branch with this corner, which is no row itself, may hold what is looked for.
  using May = base::FunctionRef<bool(const Units* corner)>;
  /// Is shown an item; true ends the search.
  using Show = base::FunctionRef<bool(std::uint32_t item)>;

  /// Rows have so many entries.
  explicit BoundingForest(std::size_t width) : width_(width) {}

  void add(std::uint32_t item, Row row);
  /// Shows the items of branches whose greatest entries `may` be enough; whether a search was ended.
  bool above(May may, Show show) const;
  /// The same, by the least entries.
  bool below(May may, Show show) const;

 private:
  /// The items from `begin` up to `end`; the first half is the next branch, the second half that at `second`.
  struct Branch {
    std::uint32_t begin, end;
    std::uint32_t second;  ///< 0: a leaf
  };
  struct Tree {
    std::vector<std::uint32_t> items;
    std::vector<Branch> branches;  ///< the root first
    std::vector<Units> corners;    ///< of each branch the greatest entries, then the least
  };
  class Builder;

  [[nodiscard]] bool search(bool greatest, May may, Show show) const;

  std::size_t width_;
  std::vector<std::uint32_t> waiting_;
  std::vector<Tree> trees_;  ///< by size, empty where there is none
};

}  // namespace rmpl::verifier
