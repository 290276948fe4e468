// From a lowered model program to a probabilistic hierarchical constraint automaton (ijcai01; semantics 8).
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/phca.hpp"
#include "compiler/lower/model_declarations.hpp"
#include "compiler/lower/program.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// The automaton of a model program that was lowered over what it declares. Reports each branch of a `choose` that
/// tells something in the instant of the draw, and choices that multiply beyond bounds. Only where no error was
/// reported does it mean what the text says.
automata::ModelProgram model_program(const LoweredProgram& lowered, const ModelDeclarations& declared,
                                     grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
