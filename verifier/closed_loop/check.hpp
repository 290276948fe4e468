// Checking a program that controls a plant (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

/// `program` is bound to the plant of `step`; the properties are asked of a program. The answers are in the order of
/// the properties and found together. Of the options the period, faults (set), `fewest_faults`, `cut_sets` (not of
/// termination), `entailed` and `from` count. Every witness has been replayed. Throws base::InputError where `from`
/// gives modes in which no state to start in is possible.
std::vector<Answer> check(const automata::Program& program, automata::PlantStep& step,
                          const std::vector<Property>& properties, const CheckOptions& options, const Limits& limits);

}  // namespace rmpl::verifier
