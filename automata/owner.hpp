// Whose a variable is, by its name.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "automata/plant.hpp"

namespace rmpl::automata {

/// The component whose mode a variable is, or that it belongs to by its name, `component.attribute`; none for a port of
/// a module.
std::optional<ComponentId> owner_of(const Plant& plant, VariableId variable);

}  // namespace rmpl::automata
