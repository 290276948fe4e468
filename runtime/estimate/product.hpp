// The best states of a product of beliefs, multiplied out only as far as they are wanted.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "runtime/estimate/estimator.hpp"

namespace runtime {

/// A belief over some of the components.
struct Factor {
  const Belief* belief;
  std::span<const automata::ComponentId> components;
};

/// The `most` best states of the product, in the order of `Belief`; each factor is normalised, and so is the product,
/// of which this is the head.
Belief product(std::span<const Factor> factors, std::size_t components, std::size_t most);

}  // namespace runtime
