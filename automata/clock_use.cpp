// Which clocks are needed at all.
// SPDX-License-Identifier: MIT
#include "automata/clock_use.hpp"

#include <algorithm>

namespace rmpl::automata {

bool needs_clock(const Component& component, ModeId mode) {
  return std::any_of(component.transitions.begin(), component.transitions.end(),
                     [&](const Transition& t) { return t.from == mode && needs_clock(t); });
}

}  // namespace rmpl::automata
