// Islands that nothing contradicts: whatever the modes and the controls, their constraints can hold.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/plant.hpp"
#include "automata/step/support.hpp"

namespace automata {

/// Whether the island's constraints have a model for all modes and all values of its controls. Sufficient: false where
/// that is not seen.
///
/// Attributes are taken away one by one, effects before their causes: an attribute goes, with all constraints that
/// still read it, where these leave it a value whatever everything else is. In a plant whose components compute their
/// outputs from their inputs, without loops, all attributes go. The order needs no declared direction.
bool is_total(const Plant& plant, const Locality::Island& island);

}  // namespace automata
