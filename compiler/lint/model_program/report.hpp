// What is told of a model program: the parts of the report, and what they have in common.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/phca.hpp"
#include "compiler/lint/lint.hpp"
#include "compiler/lint/model_program/reachable_markings.hpp"
#include "compiler/lint/model_program/told_stores.hpp"
#include "compiler/lint/program/unreached_steps.hpp"

namespace rmpl::compiler {

/// Refers to all that it is given.
class ModelReport {
 public:
  ModelReport(const LintInput& input, const automata::ModelProgram& program, const ProgramPlaces& places,
              grammar::Diagnostics& found)
      : input_(input),
        program_(program),
        places_(places),
        found_(found),
        stores_(program),
        together_(started_together(program)) {}

  [[nodiscard]] const LintInput& input() const { return input_; }
  [[nodiscard]] const automata::ModelProgram& program() const { return program_; }
  /// Without locations for a plant that holds model programs.
  [[nodiscard]] const ProgramPlaces& places() const { return places_; }
  ToldStores& stores() { return stores_; }
  /// The locations that may be marked.
  const std::vector<bool>& reachable();
  /// As `started_together`.
  [[nodiscard]] const std::vector<std::vector<automata::LocationId>>& together() const { return together_; }

  [[nodiscard]] grammar::Span span_of(automata::LocationId location) const;
  /// The name of the definition that starts, or of the plant; nothing of what came compiled.
  [[nodiscard]] std::optional<grammar::Span> name() const;
  grammar::Diagnostic& add(grammar::Code code, grammar::Span span, std::string message);
  /// Adds a note for each part of a contradiction: what is told, what stands.
  void blame(grammar::Diagnostic& finding, const ToldContradiction& contradiction) const;

 private:
  const LintInput& input_;
  const automata::ModelProgram& program_;
  const ProgramPlaces& places_;
  grammar::Diagnostics& found_;
  ToldStores stores_;
  std::vector<std::vector<automata::LocationId>> together_;
  std::vector<bool> reachable_;  ///< empty: not asked for yet
};

/// A start that contradicts itself, or branches of a draw before the start that do. False where there is no start at
/// all: then nothing else means anything.
bool report_start(ModelReport& report);
/// What is told together, and cannot be.
void report_contradictions(ModelReport& report);
/// Conditions that never hold, or always.
void report_conditions(ModelReport& report);
/// Variables that nothing speaks of.
void report_unspoken(ModelReport& report);
/// Where its locations stand, and whether they may be marked.
void add_marked(ModelReport& report, MarkedSpans& marked);

}  // namespace rmpl::compiler
