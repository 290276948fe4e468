// The programs of a document with what belongs to them: plant, places, the modes that scenarios add.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "compiler/lint/lint.hpp"

namespace rmpl::compiler {

struct BoundProgram {
  const automata::Program& program;
  const automata::Plant* plant;            ///< null where it has none
  const ProgramPlaces& places;             ///< empty where the program came compiled
  std::vector<automata::Assignment> also;  ///< modes that a scenario of the program starts in, or forces
  automata::Ticks cycle;                   ///< the longest of its scenarios'
};

std::vector<BoundProgram> bound_programs(const LintInput& input);

/// Where a location stands; the place of its origin where the program came compiled.
grammar::Span span_of(const LintInput& input, const BoundProgram& bound, automata::LocationId location);

}  // namespace rmpl::compiler
