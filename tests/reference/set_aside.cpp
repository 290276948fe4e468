// Readings that nothing explains, by trying every subset.
// SPDX-License-Identifier: MIT
#include "tests/reference/set_aside.hpp"

#include <algorithm>
#include <vector>

namespace rmpl::reference {

std::optional<SetAside> set_aside(const automata::Observation& seen,
                                  const std::function<bool(const automata::Observation&)>& explained) {
  for (std::size_t size = 0; size <= seen.size(); ++size) {
    std::vector<bool> chosen(seen.size(), false);
    std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(size), true);
    do {  // the first in order has its elements furthest to the front
      SetAside result;
      for (std::size_t i = 0; i < seen.size(); ++i) (chosen[i] ? result.aside : result.rest).push_back(seen[i]);
      if (explained(result.rest)) return result;
    } while (std::prev_permutation(chosen.begin(), chosen.end()));
  }
  return std::nullopt;
}

}  // namespace rmpl::reference
