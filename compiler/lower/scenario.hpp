// From a scenario as written to one that can be run (language.md "Scenarios"), with every reference checked.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/scenario.hpp"
#include "compiler/lower/part.hpp"
#include "grammar/ast/scenario.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// The parts of a scenario that name files; null where the scenario lacks one. Reports what is missing or repeated.
struct ScenarioFiles {
  const grammar::ProgramPart* program = nullptr;
  const grammar::PlantPart* plant = nullptr;
};
ScenarioFiles files_of(const grammar::ScenarioDefinition& definition, grammar::Diagnostics& diagnostics);

/// The scenario over a plant. Which program and plant of the document it uses is for the caller to fill in. Without a
/// plant (it is in error, and that is reported) only what needs none is checked.
automata::Scenario lower_scenario(const grammar::Sources& sources, const grammar::ScenarioDefinition& definition,
                                  const Part* plant, grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
