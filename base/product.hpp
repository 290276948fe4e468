// Every way of taking one of each list: the one place where choices are multiplied out.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace rmpl::base {

/// Depth first, the first list outermost, each list in its order. `take(l, i)` is asked whether option `i` of list `l`
/// may be taken beside what is taken of the lists before; where it said yes, `put_back(l, i)` is called when all that
/// goes with it has been visited. `visit()` is called when one of each is taken, and ends it all where it returns true.
/// Whether it did. Where something is thrown nothing is put back. Takes no stack for the number of lists.
template <class Lists, class Take, class PutBack, class Visit>
bool multiply_out(const Lists& lists, const Take& take, const PutBack& put_back, const Visit& visit) {
  if (lists.size() == 0) return visit();
  std::vector<std::size_t>
      next;  // of each list that is open, the option to come; the one before is taken but for the last
  next.reserve(lists.size());
  next.push_back(0);
  while (!next.empty()) {
    const std::size_t l = next.size() - 1;
    if (next[l] == lists[l].size()) {
      next.pop_back();
      if (l > 0) put_back(l - 1, next[l - 1] - 1);
      continue;
    }
    const std::size_t i = next[l]++;
    if (!take(l, i)) continue;
    if (l + 1 < lists.size()) {
      next.push_back(0);
      continue;
    }
    const bool ended = visit();
    put_back(l, i);
    if (!ended) continue;
    for (std::size_t open = l; open-- > 0;) put_back(open, next[open] - 1);
    return true;
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
