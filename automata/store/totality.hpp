// Islands that nothing contradicts: whatever the modes and the controls, their constraints can hold.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/plant.hpp"
#include "automata/store/support.hpp"

namespace rmpl::automata {

/// Whether the island's constraints have a model for all modes and all values of its controls (Elimination).
/// Sufficient: false where that is not seen.
bool is_total(const Plant& plant, const Island& island);

}  // namespace rmpl::automata
