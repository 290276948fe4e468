// Functions of few events as tables: a row for each set of events.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

namespace rmpl::reference {

/// By set of events, the bits of its number: whether it makes the function true.
using TruthTable = std::vector<bool>;

inline TruthTable event_table(std::size_t events, std::size_t event) {
  TruthTable result(std::size_t{1} << events);
  for (std::size_t set = 0; set < result.size(); ++set) result[set] = (set >> event & 1) != 0;
  return result;
}

template <class Combine>
TruthTable combined(const TruthTable& a, const TruthTable& b, const Combine& combine) {
  TruthTable result(a.size());
  for (std::size_t set = 0; set < a.size(); ++set) result[set] = combine(a[set], b[set]);
  return result;
}

/// By size: how many sets make it true of which no proper subset does.
inline std::vector<std::size_t> minimal_sets(const TruthTable& table) {
  std::vector<std::size_t> result;
  for (std::size_t set = 0; set < table.size(); ++set) {
    bool minimal = table[set];
    for (std::size_t other = 0; other < set && minimal; ++other) minimal = !table[other] || (other & set) != other;
    if (!minimal) continue;
    const auto size = static_cast<std::size_t>(std::popcount(set));
    result.resize(std::max(result.size(), size + 1), 0);
    ++result[size];
  }
  return result;
}

/// The probability that it is true, of events that are independent.
inline long double probability(const TruthTable& table, const std::vector<double>& events) {
  long double result = 0;
  for (std::size_t set = 0; set < table.size(); ++set) {
    long double one = table[set] ? 1 : 0;
    for (std::size_t e = 0; e < events.size(); ++e) {
      const long double p = events[e];
      one *= (set >> e & 1) != 0 ? p : 1 - p;
    }
    result += one;
  }
  return result;
}

}  // namespace rmpl::reference
