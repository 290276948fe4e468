// A model program as the plant that a control program sees.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/phca.hpp"
#include "automata/plant.hpp"

namespace rmpl::automata {

/// A plant over the same variables, whose components are what goals may name: what locations tell of, but for commands.
/// A component has a mode for each value of its variable, and behind these one more, `?`, where the store leaves the
/// value open. It has no transitions: what it does is up to the program, which `can_be_flown`.
Plant facade_of(const ModelProgram& program);

/// Whether every control has an idle value, so that it can be left alone.
bool can_be_flown(const ModelProgram& program);

/// Whether a mode of a facade leaves its variable open.
inline bool is_open(const Plant& plant, const Component& component, ModeId mode) {
  return mode.index() >= plant.variables[component.mode].values.size();
}

}  // namespace rmpl::automata
