// Cumulative hazards of densities without bounds, exact where they are small.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/time/density.hpp"

namespace rmpl::automata {

/// -ln of (1 - F(to)) / (1 - F(from)), where F is the distribution of an exponential, Weibull or Erlang density without
/// bounds; to twelve digits. 0 <= from < to < infinity.
double cumulative_hazard(const Density& density, Ticks from, Ticks to);

/// ln of F(at) / F(later), where both are too small for a double, or nearly; to twelve digits. 0 < at <= later.
double log_ratio_of_small(const Density& density, Ticks at, Ticks later);

}  // namespace rmpl::automata
