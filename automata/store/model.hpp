// The plant model as a constraint store: Q and every mode's constraint under its mode (thesis 6.1.4, C_M).
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"

namespace rmpl::automata {

/// Tells a theory, whose variables begin with the plant's, the interconnections, and M(x = v) wherever x = v is
/// assumed.
void tell_model(Theory& theory, const Plant& plant);

/// A theory that holds the interconnections, and M(x = v) wherever x = v is assumed. Asked with the modes of a state
/// as assumptions, it is the store C_M of that state.
Theory model_theory(const Plant& plant, Theory::Upkeep upkeep = Theory::Upkeep::maintained);

}  // namespace rmpl::automata
