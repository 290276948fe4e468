// From a file of properties to what is claimed of a plant, and of a program, with every reference checked.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/plant.hpp"
#include "automata/property.hpp"
#include "grammar/ast/property.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// The properties in the order of the file, which begins at `start`. Claims on a program are errors unless there is
/// one: `under_program`. They mean something only where nothing is reported.
std::vector<automata::PlantProperty> lower_properties(const grammar::Sources& sources,
                                                      const grammar::PropertyFile& file, grammar::Span start,
                                                      const automata::Plant& plant, bool under_program,
                                                      grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
