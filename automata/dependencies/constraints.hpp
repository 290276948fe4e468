// The constraints of a plant, one by one: what its store is made of.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/plant.hpp"

namespace rmpl::automata {

/// A conjunct of Q, or of a mode's constraint: then under that mode.
struct Constraint {
  std::optional<Assignment> under;
  Formula formula;
};

/// All conjuncts but those that are true: those of Q, then those of the modes.
std::vector<Constraint> constraints_of(const Plant& plant);

}  // namespace rmpl::automata
