// Instances: copies of a plant under a name, within a larger one.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "automata/plant.hpp"

namespace rmpl::automata {

/// `engine` and `temp` make `engine.temp`; `engine` and nothing make `engine`.
std::string qualified(std::string_view instance, std::string_view name);

/// Moves a variable, or every variable of a formula, by `offset`, up or down; domains stay as they are.
void shift(VariableId& id, std::ptrdiff_t offset);
void shift(Formula& formula, std::ptrdiff_t offset);

/// Puts a copy of `type` into `whole` under the name of an instance: behind what is there in every list, together and
/// in order, so that renaming is adding an offset. What is named "" takes the instance's name. The names must be new.
void instantiate(Plant& whole, std::string_view instance, const Plant& type);

}  // namespace rmpl::automata
