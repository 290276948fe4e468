// Every policy by itself, by elimination.
// SPDX-License-Identifier: MIT
#include "tests/reference/policies.hpp"

#include <algorithm>
#include <functional>

#include "base/product.hpp"

namespace rmpl::reference {

namespace {

/// What one policy makes of the process; no choice where a run ends.
using Chain = std::vector<RationalProcess::Choice>;

void for_each_chain(const RationalProcess& process, const std::function<void(const Chain&)>& visit) {
  std::vector<std::vector<RationalProcess::Choice>> lists;
  for (std::size_t s = 0; s < process.choices.size(); ++s) {
    const bool ends = process.wanted[s] || process.choices[s].empty();
    lists.push_back(ends ? std::vector<RationalProcess::Choice>(1) : process.choices[s]);
  }
  base::for_each_combination(lists, visit);
}

std::vector<bool> reachable(const Chain& chain, std::size_t start) {
  std::vector<bool> result(chain.size(), false);
  result[start] = true;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t s = 0; s < chain.size(); ++s) {
      for (const auto& [to, probability] : chain[s]) {
        if (result[s] && !result[to]) result[to] = changed = true;
      }
    }
  }
  return result;
}

/// States from which a wanted one can be reached.
std::vector<bool> hopeful(const Chain& chain, const std::vector<bool>& wanted) {
  std::vector<bool> result;
  for (std::size_t s = 0; s < chain.size(); ++s) {
    const std::vector<bool> met = reachable(chain, s);
    bool any = false;
    for (std::size_t t = 0; t < met.size(); ++t) any = any || (met[t] && wanted[t]);
    result.push_back(any);
  }
  return result;
}

/// The solution of value(s) = constant(s) + the mean of the values that follow, over some of the states; elsewhere the
/// value is its constant (C. F. Gauss).
std::vector<Rational> solve(const Chain& chain, const std::vector<bool>& open, std::vector<Rational> constants) {
  const std::size_t size = chain.size();
  std::vector<std::vector<Rational>> matrix(size, std::vector<Rational>(size));
  for (std::size_t s = 0; s < size; ++s) {
    matrix[s][s] = 1;
    if (!open[s]) continue;
    for (const auto& [to, probability] : chain[s]) matrix[s][to] -= probability;
  }
  for (std::size_t p = 0; p < size; ++p) {
    std::size_t pivot = p;
    while (matrix[pivot][p] == 0) ++pivot;
    std::swap(matrix[p], matrix[pivot]);
    std::swap(constants[p], constants[pivot]);
    for (std::size_t s = 0; s < size; ++s) {
      if (s == p || matrix[s][p] == 0) continue;
      const Rational factor = matrix[s][p] / matrix[p][p];
      for (std::size_t c = p; c < size; ++c) matrix[s][c] -= factor * matrix[p][c];
      constants[s] -= factor * constants[p];
    }
  }
  for (std::size_t s = 0; s < size; ++s) constants[s] /= matrix[s][s];
  return constants;
}

}  // namespace

Probabilities ever(const RationalProcess& process, std::size_t start) {
  Probabilities result{1, 0};
  for_each_chain(process, [&](const Chain& chain) {
    std::vector<bool> open = hopeful(chain, process.wanted);
    std::vector<Rational> constants(chain.size(), 0);
    for (std::size_t s = 0; s < chain.size(); ++s) {
      if (!process.wanted[s]) continue;
      open[s] = false;
      constants[s] = 1;
    }
    const Rational value = solve(chain, open, constants)[start];
    result.least = std::min(result.least, value);
    result.greatest = std::max(result.greatest, value);
  });
  return result;
}

MeanSteps mean_steps(const RationalProcess& process, std::size_t start) {
  MeanSteps result{std::nullopt, Rational(0)};
  for_each_chain(process, [&](const Chain& chain) {
    const std::vector<bool> met = reachable(chain, start);
    const std::vector<bool> hope = hopeful(chain, process.wanted);
    for (std::size_t s = 0; s < chain.size(); ++s) {
      if (met[s] && !hope[s]) {
        result.greatest.reset();
        return;
      }
    }
    std::vector<bool> open = met;
    std::vector<Rational> constants(chain.size(), 0);
    for (std::size_t s = 0; s < chain.size(); ++s) {
      open[s] = open[s] && !process.wanted[s];
      if (open[s]) constants[s] = 1;
    }
    const Rational value = solve(chain, open, constants)[start];
    if (!result.least || value < *result.least) result.least = value;
    if (result.greatest && value > *result.greatest) result.greatest = value;
  });
  return result;
}

}  // namespace rmpl::reference
