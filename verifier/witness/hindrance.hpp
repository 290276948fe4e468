// Why a run waits for ever: which components would have to move, and what keeps each where it is.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/program.hpp"
#include "automata/step/plant_step.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// Per component that the marked locations wait for, in declaration order: what the last cycle of the run says of its
/// nominal transitions to other modes. Nothing where they wait for none.
std::vector<Hindrance> hindrances(automata::PlantStep& step, const automata::Program& program, const Witness& witness);

/// `no nominal transition leads 'held' out of 'stay' (unfair.tcca:5:3)`.
std::string to_text(const automata::Plant& plant, const Hindrance& hindrance);

}  // namespace rmpl::verifier
