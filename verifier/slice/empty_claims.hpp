// Claims that a model decides before any run of it is looked at (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/logic/formula.hpp"
#include "verifier/property/property.hpp"
#include "verifier/slice/slices.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

/// Whether the formula needs a fault: some state satisfies it if components may take faults from the modes of `from`,
/// or the initial ones, and no state does if they may not. Guards are taken to hold. Cost: two questions to the solver.
bool takes_a_fault(Slices& slices, const automata::Formula& formula, const std::vector<automata::Assignment>& from);

/// The formula of the property that needs a fault while none is permitted. Nothing for responses: their verdict says
/// that the trigger never holds.
std::optional<automata::Formula> out_of_reach(Slices& slices, const Property& property, const CheckOptions& options);

/// Why the model can never satisfy the forbidden formula, or, with `entailed`, never imply it.
std::optional<Vacuity> vacuity_of_never(Slices& slices, const automata::Formula& never, bool entailed);

/// The promise of the property, if every state satisfies it.
std::optional<automata::Formula> there_anyway(Slices& slices, const Property& property);

/// Whether the trigger of a response is about modes alone and always satisfies the answer.
bool answers_itself(Slices& slices, const Property& property);

}  // namespace rmpl::verifier
