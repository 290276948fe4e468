// From a program as written to a timed hierarchical constraint automaton (thesis 5.2.2, semantics 2).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/program.hpp"
#include "compiler/check/definitions.hpp"
#include "compiler/check/recursion.hpp"
#include "compiler/lower/model_parts.hpp"
#include "compiler/lower/part.hpp"
#include "compiler/lower/program_places.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// A program that was lowered. Only where no error was reported does it mean what the text says.
struct LoweredProgram {
  automata::Program program;
  ProgramPlaces places;
  ModelParts model;      ///< of a model program
  bool complete = true;  ///< false: it is too large or nests too deep, and the rest was not looked at
};

/// What a program is lowered for: to be run, or for the sake of the errors in definitions that no program uses. Then a
/// definition that was looked at before is not looked at again.
enum class Purpose { run, check };

/// Lowers the program that starts at `entry`. With a plant, names are checked against it and the program is bound to
/// it; without, names are taken as they come. A model program is given what it declares as a plant. The parameters of
/// `entry`, if it has any, stand for anything. Marks in `reached` the definitions that take part.
LoweredProgram lower_program(const grammar::Sources& sources, const Definitions& definitions,
                             const Recursion& recursion, std::size_t entry, Purpose purpose, const Part* plant,
                             std::vector<bool>& reached, grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
