// The best states of a product of beliefs, multiplied out only as far as they are wanted.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

/// A belief over some of the components.
struct Factor {
  const Belief* belief;
  std::span<const automata::ComponentId> components;
};

/// No more states than this are multiplied out.
constexpr std::size_t most_states = 1u << 20;

/// How many states the product has; saturates.
std::size_t product_size(std::span<const Factor> factors);

/// The `most` best states of the product, in the order of `Belief`; each factor is normalised, and so is the product,
/// of which this is the head. Throws TooManyStates where these are more than `most_states`.
Belief product(std::span<const Factor> factors, std::size_t components, std::size_t most);

/// The states of the `most` best mode combinations of the product; of each at most `clocks` sets of clocks, the best.
Belief product_by_modes(std::span<const Factor> factors, std::size_t components, std::size_t most, std::size_t clocks);

}  // namespace rmpl::runtime
