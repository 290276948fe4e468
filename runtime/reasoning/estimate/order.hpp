// Most probable first, with ties told apart by declaration order whatever the last bits say.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

namespace rmpl::runtime {

/// Probabilities whose ratio is nearer to 1 than this are ties: equal products, multiplied in another order, differ in
/// the last bits.
inline constexpr double tie_tolerance = 1e-12;

/// Sorts by member `probability`, falling; a run of items within `tie_tolerance` of its first one is tied, and is in
/// order of `before`, a total order. "Nearly equal" alone would be no strict weak order. `go_on` is called often, and
/// may throw: the items are in any order then, and some may be lost.
template <class Item, class Before, class GoOn>
void put_in_order(std::vector<Item>& items, Before before, GoOn go_on) {
  std::sort(items.begin(), items.end(), [&](const Item& a, const Item& b) {
    go_on();
    return a.probability != b.probability ? a.probability > b.probability : before(a, b);
  });
  for (auto run = items.begin(); run != items.end();) {
    const double least = run->probability * (1 - tie_tolerance);
    const auto end = std::find_if(run, items.end(), [&](const Item& item) { return item.probability < least; });
    std::sort(run, end, [&](const Item& a, const Item& b) {
      go_on();
      return before(a, b);
    });
    run = end;
  }
}

template <class Item, class Before>
void put_in_order(std::vector<Item>& items, Before before) {
  put_in_order(items, before, [] {});
}

}  // namespace rmpl::runtime
