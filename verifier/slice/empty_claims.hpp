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

/// Whether some state satisfies the formula whose components are in modes that they come to, from those given by `from`
/// or the initial ones, whatever guards say, but none in which they come there without a fault. Cost: two questions to
/// the solver.
bool takes_a_fault(Slices& slices, const automata::Formula& formula, const std::vector<automata::Assignment>& from);

/// What the property asks whether it happens, where that takes a fault and none is permitted. Nothing of responses:
/// their verdict tells that nothing asks.
std::optional<automata::Formula> out_of_reach(Slices& slices, const Property& property, const CheckOptions& options);

/// Whether nothing in the model can ever satisfy what is never to hold, or imply it, where that is what counts.
std::optional<Vacuity> vacuity_of_never(Slices& slices, const automata::Formula& never, bool entailed);

/// What the property asks to come, where every state satisfies it.
std::optional<automata::Formula> there_anyway(Slices& slices, const Property& property);

/// Whether a response asks of modes alone, and whatever asks for it is its answer.
bool answers_itself(Slices& slices, const Property& property);

}  // namespace rmpl::verifier
