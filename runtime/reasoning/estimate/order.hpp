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
/// order of `before`, a total order. "Nearly equal" alone would be no strict weak order.
template <class Item, class Before>
void put_in_order(std::vector<Item>& items, Before before) {
  std::sort(items.begin(), items.end(), [&](const Item& a, const Item& b) {
    return a.probability != b.probability ? a.probability > b.probability : before(a, b);
  });
  for (auto run = items.begin(); run != items.end();) {
    const double least = run->probability * (1 - tie_tolerance);
    const auto end = std::find_if(run, items.end(), [&](const Item& item) { return item.probability < least; });
    std::sort(run, end, before);
    run = end;
  }
}

}  // namespace rmpl::runtime
