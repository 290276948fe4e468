// Whether a timed transition fires in a step, as far as its bounds tell: possibility in sampled time is decided here.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "automata/time/density.hpp"

namespace rmpl::automata {

enum class Firing : std::uint8_t { impossible, possible, certain };

/// In the step that takes the clock from `from` to `to`, by exact comparison: the density has weight everywhere between
/// its bounds, be it less than a double can hold.
inline Firing firing(const Timing& timing, Ticks from, Ticks to) {
  if (to >= timing.upper) return Firing::certain;
  return to > timing.lower && to > from ? Firing::possible : Firing::impossible;
}

}  // namespace rmpl::automata
