// What a plant with model programs may tell, as one of these.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/phca.hpp"
#include "automata/software/model_component.hpp"

namespace rmpl::compiler {

/// A location for each mode, which tells the mode and its constraint, beside the model programs, each in a composite.
/// An arc leads where a transition does, whatever the time and its weight: the program may come to more than the plant.
automata::ModelProgram told_program(const automata::PlantWithModels& whole);

}  // namespace rmpl::compiler
