// What a plant is without the attributes that make no difference to its modes and guards.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/plant.hpp"

namespace rmpl::automata {

/// The plant with the same modes, controls and guards, where attributes are left out that no guard reads and that have
/// a value to suit their constraints whatever the others are: housekeeping telemetry, most often. Which modes are
/// possible, and which guards they imply, is not changed by that. An attribute that is left out keeps its `VariableId`,
/// takes one value only, and occurs in no constraint (Elimination).
Plant relevant_part(const Plant& plant);

}  // namespace rmpl::automata
