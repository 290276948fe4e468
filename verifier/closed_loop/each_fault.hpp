// What can come of each fault of a plant by itself, under a program that controls it (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/program.hpp"
#include "automata/step/plant_step.hpp"
#include "verifier/verdict/answer.hpp"
#include "verifier/verdict/fault_table.hpp"

namespace rmpl::verifier {

/// Takes every fault by itself, or those of some components; none: of all. `program` is bound to the plant of `step`;
/// `properties` say what the mission is; `options.faults` is not looked at. Every witness has been replayed.
FaultTable check_each_fault(const automata::Program& program, automata::PlantStep& step,
                            const std::vector<Property>& properties, const CheckOptions& options, const Limits& limits,
                            const std::vector<automata::ComponentId>& components = {});

}  // namespace rmpl::verifier
