// Which clocks are needed at all.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/plant.hpp"

namespace rmpl::automata {

/// Whether it makes a difference to a transition how long its mode has lasted. An exponential time from 0 on without
/// end has no memory: what is left of it never depends on what has passed.
inline bool needs_clock(const Transition& t) { return t.timing && !t.timing->memoryless(); }

/// Whether the clock of a component in a mode makes a difference to some transition out of it; of a fault with time
/// bounds it does.
bool needs_clock(const Component& component, ModeId mode);

}  // namespace rmpl::automata
