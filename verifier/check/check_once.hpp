// Checking a property of a plant for one number of faults.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/search/limits.hpp"
#include "verifier/slice/slices.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

/// With up to so many faults, whatever the options say of them. Every witness has been replayed, those of cut sets too.
Answer check_once(Slices& slices, const Property& property, const CheckOptions& options, unsigned faults, Meter& meter);
/// The same where any witness will do, not one with fewest steps.
Answer check_for_any_witness(Slices& slices, const Property& property, const CheckOptions& options, unsigned faults,
                             Meter& meter);

}  // namespace rmpl::verifier
