// Single random draws that shrink towards the simple: the vocabulary of the generators.
// SPDX-License-Identifier: MIT
#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <vector>

namespace rmpl::property {

// Only inside rc::gen::exec, or in the body of a property. RapidCheck narrows ranges in the first cases of a run; these
// draws do not, so that every case is as wild as the next.

/// least … most; shrinks towards `least`.
inline std::size_t up_to(std::size_t least, std::size_t most) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, most + 1));
}
/// True in `percent` of the cases; shrinks towards false.
inline bool chance(std::size_t percent) { return up_to(0, 99) >= 100 - percent; }
/// One of a list that is not empty; shrinks towards the first.
template <class T>
T pick(const std::vector<T>& from) {
  return from[up_to(0, from.size() - 1)];
}

}  // namespace rmpl::property
