// Products of sparse matrices, row by row (F. Gustavson: Two fast algorithms for sparse matrices, 1978).
// SPDX-License-Identifier: MIT
#include "verifier/markov/sparse.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rmpl::verifier {

namespace {

/// Sums of products by column. A sum of n products of terms from 0 has a relative error of at most n + 1 roundings.
class Sums {
 public:
  explicit Sums(std::size_t columns) : sums_(columns), counts_(columns, 0) {}

  void add(std::uint32_t column, const Enclosure& a, const Enclosure& b) {
    if (a.upper == 0 || b.upper == 0) return;
    if (counts_[column] == 0) touched_.push_back(column);
    Enclosure& sum = sums_[column];
    sum.lower += a.lower * b.lower;
    sum.upper += std::max(a.upper * b.upper, rounding::least);
    counts_[column] += is_certain(a) || is_certain(b) ? 1 : 2;
  }

  /// All sums, by column, which are forgotten.
  SparseMatrix::SparseRow take() {
    std::sort(touched_.begin(), touched_.end());
    SparseMatrix::SparseRow result;
    result.reserve(touched_.size());
    for (const std::uint32_t column : touched_) {
      // One product with what is certain is exact.
      const std::size_t count = counts_[column];
      result.emplace_back(column, count == 1 ? sums_[column] : as_probability(outward(sums_[column], count)));
      sums_[column] = {};
      counts_[column] = 0;
    }
    touched_.clear();
    return result;
  }

 private:
  std::vector<Enclosure> sums_;
  std::vector<std::uint32_t> counts_;
  std::vector<std::uint32_t> touched_;
};

}  // namespace

SparseMatrix::SparseMatrix(std::vector<SparseRow> rows) : rows_(std::move(rows)) {
  for (const SparseRow& row : rows_) entries_ += row.size();
}

std::size_t SparseMatrix::square_cost() const {
  std::size_t cost = 0;
  for (const SparseRow& row : rows_) {
    for (const Entry& entry : row) cost += rows_[entry.first].size();
  }
  return cost;
}

SparseMatrix SparseMatrix::squared(Meter& meter) const {
  Sums sums(rows_.size());
  std::vector<SparseRow> result;
  result.reserve(rows_.size());
  for (const SparseRow& row : rows_) {
    meter.poll();
    for (const auto& [middle, first] : row) {
      for (const auto& [column, second] : rows_[middle]) sums.add(column, first, second);
    }
    result.push_back(sums.take());
  }
  return SparseMatrix(std::move(result));
}

std::vector<Enclosure> SparseMatrix::from_left(const std::vector<Enclosure>& vector) const {
  Sums sums(rows_.size());
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (const auto& [column, value] : rows_[r]) sums.add(column, vector[r], value);
  }
  std::vector<Enclosure> result(rows_.size());
  for (const auto& [column, value] : sums.take()) result[column] = value;
  return result;
}

namespace {

/// A step stays where it is, or goes on to another state with a probability that no state exceeds half of.
class SeldomLeft {
 public:
  explicit SeldomLeft(const SparseMatrix& matrix) {
    Real most = 0;
    for (std::size_t r = 0; r < matrix.size(); ++r) most = std::max(most, leaving(matrix, r).upper);
    // A power of two, so that 1 less it is exact.
    if (most > 0 && most < 0x1p-8L) probability_ = std::exp2(std::ceil(std::log2(most)) + 1);
  }

  /// How many times it goes on at most, but for a probability of less than `ignored`; none where it is not worth it.
  [[nodiscard]] std::optional<std::uint64_t> most_times(std::uint64_t steps) const {
    const Real mean = probability_ * static_cast<Real>(steps);
    // Beyond that, the probability of never going on would be no number any more.
    constexpr Real greatest_mean = 4096;
    if (probability_ < 0x1p-48L || mean > greatest_mean) return std::nullopt;
    return static_cast<std::uint64_t>(mean + 12 * std::sqrt(mean) + 40);
  }

  std::vector<Enclosure> after(std::vector<Enclosure> vector, const SparseMatrix& matrix, std::uint64_t steps,
                               Real ignored, Meter& meter) const {
    const SparseMatrix going_on = of(matrix);
    const Enclosure goes{probability_, probability_};
    const Enclosure stays{1 - probability_, 1 - probability_};
    Enclosure weight = power(stays, steps);  // of going on so many times
    std::vector<Enclosure> result(vector.size());
    for (std::uint64_t times = 0;; ++times) {
      meter.poll();
      for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[i] + weight * vector[i];
      if (times == steps) return result;
      const auto left = static_cast<Real>(steps - times);
      const auto next = static_cast<Real>(times + 1);
      weight = weight * goes / stays * Enclosure{left, left} / Enclosure{next, next};
      // From here on weights fall by that factor at least.
      const Real falls = probability_ / (1 - probability_) * left / next;
      if (falls < 0.5L && 2 * weight.upper < ignored) {
        // At most twice this weight is left, whatever becomes of it.
        result.back().upper = rounding::up(result.back().upper + 2 * weight.upper, 2);
        return result;
      }
      vector = going_on.from_left(vector);
    }
  }

 private:
  static Enclosure leaving(const SparseMatrix& matrix, std::size_t r) {
    Enclosure result;
    for (const auto& [column, value] : matrix.row(r)) {
      if (column != r) result = result + value;
    }
    return result;
  }

  /// What becomes of it as it goes on.
  [[nodiscard]] SparseMatrix of(const SparseMatrix& matrix) const {
    const Enclosure goes{probability_, probability_};
    std::vector<SparseMatrix::SparseRow> rows;
    rows.reserve(matrix.size());
    for (std::size_t r = 0; r < matrix.size(); ++r) {
      const Enclosure left = leaving(matrix, r) / goes;  // a half at most
      auto& row = rows.emplace_back();
      const Enclosure rest = outward({1 - left.upper, 1 - left.lower}, 1);
      bool stays = false;
      for (const auto& [column, value] : matrix.row(r)) {
        if (column > r && !stays) {
          row.emplace_back(static_cast<std::uint32_t>(r), as_probability(rest));
          stays = true;
        }
        if (column != r) row.emplace_back(column, as_probability(value / goes));
      }
      if (!stays) row.emplace_back(static_cast<std::uint32_t>(r), as_probability(rest));
    }
    return SparseMatrix(std::move(rows));
  }

  static Enclosure power(Enclosure base, std::uint64_t exponent) {
    Enclosure result = certain();
    for (; exponent > 0; exponent /= 2) {
      if (exponent % 2 == 1) result = result * base;
      base = base * base;
    }
    return result;
  }

  Real probability_ = 0;
};

}  // namespace

std::vector<Enclosure> after_steps(std::vector<Enclosure> vector, SparseMatrix matrix, std::uint64_t steps,
                                   Real ignored, Meter& meter) {
  const SeldomLeft seldom(matrix);
  const auto times = seldom.most_times(steps);
  if (times && *times < steps) return seldom.after(std::move(vector), matrix, steps, ignored, meter);
  while (steps > 0) {
    const bool squares = steps >= 2 && matrix.square_cost() < steps / 2 * matrix.entries();
    if (!squares) {
      meter.poll();
      vector = matrix.from_left(vector);
      --steps;
      continue;
    }
    if (steps % 2 == 1) vector = matrix.from_left(vector);
    matrix = matrix.squared(meter);
    steps /= 2;
  }
  return vector;
}

}  // namespace rmpl::verifier
