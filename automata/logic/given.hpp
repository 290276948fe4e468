// Formulas of which some variables are given.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "automata/logic/formula.hpp"

namespace rmpl::automata {

/// The formula with what it says of the given variables replaced by what is so. Nothing is folded.
Formula with_values(const Formula& formula, std::span<const Assignment> given);

}  // namespace rmpl::automata
