// What is commanded, among the variables of a plant.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "automata/logic/formula.hpp"
#include "automata/plant.hpp"

namespace rmpl::automata {

/// The place of a variable among the plant's controls; nothing where it is none.
std::optional<std::size_t> control_of(const Plant& plant, VariableId variable);
/// Whether a variable is one of the plant's controls.
bool is_control(const Plant& plant, VariableId variable);
/// Whether a formula mentions one.
bool speaks_of_control(const Plant& plant, const Formula& formula);

}  // namespace rmpl::automata
