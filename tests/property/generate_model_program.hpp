// Random small model programs and what is told to them; well formed by construction.
// SPDX-License-Identifier: MIT
#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <vector>

#include "automata/phca.hpp"
#include "automata/state.hpp"

namespace rmpl::property {

struct RandomModelProgram {
  automata::ModelProgram program;
};
void showValue(const RandomModelProgram& program, std::ostream& out);

/// Any tree of locations with any arcs, whatever the compiler would emit and more. `most_primitive` bounds the draws of
/// a step.
rc::Gen<RandomModelProgram> model_programs(std::size_t most_primitive = 6);

/// One update: the value of each commanded variable, where it is known, and readings.
struct ModelInput {
  std::vector<std::optional<automata::ValueId>> command;
  automata::Observation observation;
};
void showValue(const ModelInput& input, std::ostream& out);
rc::Gen<std::vector<ModelInput>> model_inputs(const automata::ModelProgram& program, std::size_t most);

}  // namespace rmpl::property
