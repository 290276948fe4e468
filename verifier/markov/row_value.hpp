// What a choice is worth, and the best of several.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "verifier/markov/decision_process.hpp"

namespace rmpl::verifier {

/// The mean of probabilities over what a row leads to. What is left out may be worth anything up to 1.
inline Enclosure row_value(const Row& row, const std::vector<Enclosure>& values) {
  Enclosure sum;
  std::size_t count = 1;
  bool all_certain = row.left_out == 0 && !row.edges.empty();
  for (const Branch& edge : row.edges) {
    const Enclosure& value = values[edge.to];
    all_certain = all_certain && is_certain(value);
    if (value.upper == 0) continue;
    sum.lower += edge.probability.lower * value.lower;
    sum.upper += std::max(edge.probability.upper * value.upper, rounding::least);
    count += 2;
  }
  // All that may follow has 1, and so has this.
  if (all_certain) return certain();
  sum.upper += row.left_out;
  return as_probability(outward(sum, count));
}

inline bool is_better(Real a, Real b, Aim aim) { return aim == Aim::greatest ? a > b : a < b; }

/// There is a row at least.
inline Enclosure best_value(const std::vector<Row>& rows, const std::vector<Enclosure>& values, Aim aim) {
  Enclosure best = row_value(rows.front(), values);
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const Enclosure value = row_value(rows[r], values);
    if (is_better(value.lower, best.lower, aim)) best.lower = value.lower;
    if (is_better(value.upper, best.upper, aim)) best.upper = value.upper;
  }
  return best;
}

}  // namespace rmpl::verifier
