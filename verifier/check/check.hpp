// Checking a property of a plant.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/slice/slices.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

/// Checks one property of a plant alone. Every witness has been replayed. Throws base::InputError where `from` names
/// what is no mode, or contradicts itself, or gives modes in which no state to start in is possible.
Answer check(Slices& slices, const Property& property, const CheckOptions& options, const Limits& limits);

}  // namespace rmpl::verifier
