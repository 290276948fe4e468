// From text to trees: one function per language.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "grammar/ast/constraint.hpp"
#include "grammar/ast/plant.hpp"
#include "grammar/ast/program.hpp"
#include "grammar/ast/property.hpp"
#include "grammar/ast/scenario.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::grammar {

/// How deep constraints and steps may nest: a limit that keeps every recursive pass far from the end of the stack.
inline constexpr std::size_t nesting_limit = 400;

/// What became of a text.
template <class Tree>
struct Parse {
  Tree tree;           ///< all of it, or where the text has errors what could be told: for editors, not for lowering
  bool whole = false;  ///< the text has no errors
};

// Each parses the whole text of `sources[file]`. Where the text has errors, all of them are reported (of one place only
// the first, and at most a hundred), and the tree is a part: what was passed over is missing, names in it may be empty.
// Linear in the length of the text.

Parse<ProgramFile> parse_program(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics);
Parse<PlantFile> parse_plant(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics);
Parse<ScenarioFile> parse_scenarios(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics);
Parse<PropertyFile> parse_properties(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics);

/// A lone constraint, as on a command line.
Parse<Constraint> parse_constraint(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics);
/// A lone list of assignments, `x = v, y = w` or `x = v & y = w`; an empty text is an empty list.
Parse<std::vector<AssignmentText>> parse_assignments(const Sources& sources, std::uint32_t file,
                                                     Diagnostics& diagnostics);

}  // namespace rmpl::grammar
