// Where a lowered program stands in its source: what lint needs beside the automaton.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/logic/formula.hpp"
#include "grammar/source/span.hpp"

namespace rmpl::compiler {

/// A condition of one expansion, with its parameters replaced.
struct PlacedCondition {
  grammar::Span span;
  std::string construct;  ///< what it belongs to: `when`, `watching`, …
  automata::Formula formula;
};

/// Of a program that came from a compiled document all is empty.
struct ProgramPlaces {
  std::vector<grammar::Span> locations;  ///< per location, the step; of the program itself, its name
  std::vector<PlacedCondition> conditions;
};

}  // namespace rmpl::compiler
