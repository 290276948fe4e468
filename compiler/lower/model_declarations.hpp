// What a model program declares beside its definitions: variables, what is observed and commanded, what always holds.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/phca.hpp"
#include "compiler/check/definitions.hpp"
#include "compiler/lower/part.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

struct ModelDeclarations {
  Part part;  ///< its variables; of controls and observables only the members below are used
  std::vector<automata::CommandedVariable> controls;
  std::vector<automata::VariableId> observables;
  std::vector<automata::Interconnection> constraints;
};

/// Resolves the declarations of all files of a model program. What is wrong is reported and left out.
ModelDeclarations declare_model(const grammar::Sources& sources, const std::vector<ProgramSource>& files,
                                grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
