// From a file of monitors to what they make of telemetry, with every reference checked.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/monitor.hpp"
#include "automata/plant.hpp"
#include "grammar/ast/monitor.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// The monitors in the order of the file, which begins at `start`. They mean something only where nothing is reported.
std::vector<automata::Monitor> lower_monitors(const grammar::Sources& sources, const grammar::MonitorFile& file,
                                              grammar::Span start, const automata::Plant& plant,
                                              grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
