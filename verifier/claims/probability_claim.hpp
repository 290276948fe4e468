// A probability that a file of properties claims: worked out, and compared.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/property.hpp"
#include "verifier/markov/probability.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/verdict/subject.hpp"
#include "verifier/verdict/table.hpp"

namespace rmpl::verifier {

/// Of the subject's program with its plant, or of a plant alone under free commands.
ProbabilityAnswer probability_of(const Subject& subject, const ProbabilityQuestion& question, const Limits& limits);

/// The claim with its answer: it holds or is violated where the bounds of the probability say so, and is undecided
/// where the number that is claimed lies between them. Throws base::InputError where time as the file has it gives no
/// probability.
Claim check_probability(const Subject& subject, const automata::PlantProperty& stated, const CheckOptions& free,
                        const Bounds& bounds, const Limits& limits);

}  // namespace rmpl::verifier
