// What holds a module's instances together: interconnections, control variables, observables.
// SPDX-License-Identifier: MIT
#pragma once

#include "compiler/lower/part.hpp"
#include "grammar/ast/plant.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// Resolves the interconnections, controls and observables of a module over its ports and instances, and adds them.
void connect(const grammar::Sources& sources, const grammar::ModuleDefinition& definition, Part& part,
             grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
