// Durations, time bounds, densities and weights as written become numbers of the automata.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "automata/plant.hpp"
#include "automata/time/time.hpp"
#include "grammar/ast/plant.hpp"
#include "grammar/ast/token.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// Nothing where the duration is finer than a tick or beyond the range; then it has been reported.
std::optional<automata::Ticks> ticks_of(const grammar::Duration& duration, grammar::Diagnostics& diagnostics);

/// Bounds and density of a transition. Nothing where they are wrong; then it has been reported.
std::optional<automata::Timing> timing_of(const grammar::TimingText& text, grammar::Diagnostics& diagnostics);

/// Of a nominal transition: reports bounds without end where no density is given. A fault is drawn, and needs none.
bool check_density(const automata::Timing& timing, grammar::Span span, grammar::Diagnostics& diagnostics);

/// A probability, or a rate per second. Nothing where it is out of range; then it has been reported.
std::optional<automata::Weight> weight_of(const grammar::WeightText& text, grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
