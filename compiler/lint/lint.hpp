// Lint: what compiles, and can be proven to mean nothing, or most likely not what was meant. A finding a pass.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "automata/property.hpp"
#include "automata/scenario.hpp"
#include "compiler/lint/places.hpp"
#include "compiler/lint_codes/lint_codes.hpp"
#include "compiler/lower/program_places.hpp"
#include "compiler/session/compiler.hpp"
#include "compiler/session/files.hpp"
#include "compiler/session/names.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// What a pass sees of an input set that compiled. Programs of the document that belong to a plant have its table of
/// variables; their locations, and all in the plant, have origins, which `places` turns into spans.
struct LintInput {
  const grammar::Sources& sources;
  std::span<const File> files;  ///< the trees, whole; imports too
  const automata::Document& document;
  const std::vector<automata::PlantProperty>& properties;  ///< once for each plant that they speak of
  const NameIndex& names;
  const Places& places;
  std::span<const ProgramPlaces> programs;  ///< per program of the document; empty for one that came compiled
  std::span<const ProgramPlaces> models;    ///< per model program, likewise
  /// Plants that hold model programs, by position, as they were before the threads of these became components, and
  /// where conditions of these stand.
  const std::map<std::size_t, automata::PlantWithModels>& with_models;
  const std::map<std::size_t, ProgramPlaces>& software;
  automata::Ticks cycle;  ///< of the executive, where no scenario says it
};

/// A pass: looks for one kind of thing, by proof, and adds what it found with `add_finding`, in any order.
using LintPass = void (*)(const LintInput&, grammar::Diagnostics&);

/// The passes of lint, by subject: plants; model programs; programs, scenarios and properties.
std::span<const LintPass> model_program_passes();
std::span<const LintPass> plant_passes();
std::span<const LintPass> program_passes();

/// Adds a finding at the level of its code and returns it, for notes, a suggestion and a fix. The code has an entry
/// among the lint codes. The reference lasts until the next addition.
grammar::Diagnostic& add_finding(grammar::Diagnostics& found, grammar::Code code, grammar::Span span,
                                 std::string message);

/// All that there is to say of an input set that compiled: the warnings of the compiler and what the passes find, but
/// for what comments allow (allowances.hpp).
grammar::Diagnostics lint(const Compilation& compilation, const LintSettings& settings = {});
/// The same; what comments allow is added to `allowed`, in order of place, each at its level.
grammar::Diagnostics lint(const Compilation& compilation, const LintSettings& settings,
                          std::vector<grammar::AllowedFinding>& allowed);

}  // namespace rmpl::compiler
