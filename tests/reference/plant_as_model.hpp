// A plant with model programs as one of these: components that step without time beside them, over one store.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "automata/phca.hpp"
#include "automata/plant.hpp"
#include "automata/software/model_component.hpp"

namespace rmpl::reference {

/// One location a mode, which tells the mode and its constraint; what the model programs have stays as it is, each in a
/// composite. The belief over such a program is that over the plant, as long as no command contradicts the model.
/// `components` and interconnections first, then the models, in their order. No component has a transition that takes
/// time, nor a rate; few guards lead out of a mode.
automata::ModelProgram as_model_program(const automata::Plant& plant, std::span<const automata::ModelComponent> models);

}  // namespace rmpl::reference
