// Sets of identifiers as sorted lists.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace rmpl::runtime {

template <class T>
std::vector<T> joined(const std::vector<T>& a, const std::vector<T>& b) {
  std::vector<T> result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

template <class T>
bool meet(const std::vector<T>& a, const std::vector<T>& b) {
  return std::any_of(a.begin(), a.end(), [&](const T& x) { return std::binary_search(b.begin(), b.end(), x); });
}

template <class T>
void insert(std::vector<T>& set, const T& x) {
  const auto at = std::lower_bound(set.begin(), set.end(), x);
  if (at == set.end() || *at != x) set.insert(at, x);
}

}  // namespace rmpl::runtime
