// Every way of taking one of each list: the one place where choices are multiplied out.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace rmpl::base {

/// Depth first, the first list outermost, each list in its order. `take(l, i)` is asked whether option `i` of list `l`
/// may be taken beside what is taken of the lists before; where it said yes, `put_back(l, i)` is called when all that
/// goes with it has been visited. `visit()` is called when one of each is taken, and ends it all where it returns true.
/// Whether it did. Where something is thrown nothing is put back.
template <class Lists, class Take, class PutBack, class Visit>
bool multiply_out(const Lists& lists, const Take& take, const PutBack& put_back, const Visit& visit,
                  std::size_t l = 0) {
  if (l == lists.size()) return visit();
  for (std::size_t i = 0; i < lists[l].size(); ++i) {
    if (!take(l, i)) continue;
    const bool ended = multiply_out(lists, take, put_back, visit, l + 1);
    put_back(l, i);
    if (ended) return true;
  }
  return false;
}

/// `visit(taken)` for every combination of one of each list, in that order.
template <class T, class Visit>
void for_each_combination(const std::vector<std::vector<T>>& lists, const Visit& visit) {
  std::vector<T> taken;
  multiply_out(
      lists,
      [&](std::size_t l, std::size_t i) {
        taken.push_back(lists[l][i]);
        return true;
      },
      [&](std::size_t, std::size_t) { taken.pop_back(); },
      [&] {
        visit(static_cast<const std::vector<T>&>(taken));
        return false;
      });
}

}  // namespace rmpl::base
