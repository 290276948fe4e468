// Which changes of mode are faults, and which fault modes come about by themselves.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "automata/plant.hpp"

namespace rmpl::automata {

/// Whether a component that goes from one mode to another has a fault: it goes into a fault mode, and not as a
/// consequence of the one that it is in.
inline bool is_fault_step(const Component& component, ModeId from, ModeId to) {
  if (from == to || !component.modes[to.index()].fault) return false;
  return !component.software ||
         std::none_of(component.transitions.begin(), component.transitions.end(),
                      [&](const Transition& t) { return t.from == from && t.to == to && t.consequence; });
}

/// Whether a fault mode is that of an improbable draw right after another one: by itself it never comes about.
inline bool is_second_in_a_row(const Component& component, ModeId mode) {
  const std::optional<ModeId> usual = component.modes[mode.index()].usual;
  return usual && component.modes[mode.index() - 1].usual == usual;
}

}  // namespace rmpl::automata
