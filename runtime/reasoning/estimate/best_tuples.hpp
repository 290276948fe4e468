// The best ways of taking one of each of several lists, multiplied out only as far as they are wanted.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rmpl::runtime {

/// The probabilities of a list, each positive.
using Probabilities = std::vector<double>;

struct Tuple {
  double probability;                 ///< the product
  std::vector<std::uint32_t> places;  ///< by list
};

/// The `most` best tuples, best first, and those that are as good as the last of them as far as floating point can tell
/// (of very many, some): for the caller to put in order and cut. Where there are no more than `most`, all of them, in
/// no order. Throws TooManyStates where these are more than a million.
std::vector<Tuple> best_tuples(const std::vector<Probabilities>& lists, std::size_t most);

}  // namespace rmpl::runtime
