// The one public door to text, implemented.
// SPDX-License-Identifier: MIT
#include "compiler/session/compiler.hpp"

#include <cstdint>
#include <filesystem>
#include <utility>

#include "base/check.hpp"
#include "compiler/check/resolve.hpp"
#include "compiler/lower/property.hpp"
#include "compiler/session/files.hpp"
#include "compiler/session/input_set.hpp"
#include "grammar/parse/parse.hpp"
#include "grammar/source/render.hpp"

namespace rmpl::compiler {

struct Compilation::Result {
  grammar::Sources sources;
  grammar::Diagnostics diagnostics;
  automata::Document document;
};

Compilation::Compilation(std::unique_ptr<Result> result) : result_(std::move(result)) {}
Compilation::Compilation(Compilation&&) noexcept = default;
Compilation& Compilation::operator=(Compilation&&) noexcept = default;
Compilation::~Compilation() = default;

bool Compilation::ok() const { return !result_->diagnostics.has_errors(); }

const automata::Document& Compilation::document() const {
  CHECK(ok() && "a compilation with errors has no document");
  return result_->document;
}

std::optional<std::string> Compilation::input_at(const std::string& output) const {
  for (std::uint32_t file = 0; file < result_->sources.size(); ++file) {
    const std::string& name = result_->sources[file].name();
    std::error_code missing;
    if (std::filesystem::equivalent(output, name, missing)) return name;
  }
  return std::nullopt;
}

std::string Compilation::diagnostics(DiagnosticFormat format, bool color) const {
  const auto sorted = result_->diagnostics.sorted();
  if (sorted.empty()) return {};
  switch (format) {
    case DiagnosticFormat::text:
      return grammar::render_text(sorted, result_->sources, color);
    case DiagnosticFormat::json:
      return grammar::render_json(sorted, result_->sources);
  }
  return {};
}

Compilation compile(std::span<const std::string> paths, const Options& options) {
  auto result = std::make_unique<Compilation::Result>();
  result->document = InputSet(result->sources, result->diagnostics).compile(paths, options);
  return Compilation(std::move(result));
}

namespace {

/// A text of the command line with its own sources, judged by a plant.
struct Argument {
  Argument(std::string_view text, const automata::Plant& plant, std::string_view where)
      : file(sources.add(std::string(where), std::string(text))),
        resolver({plant.variables, nullptr, "plant " + backquoted(plant.name), grammar::Code::unknown_name},
                 diagnostics) {}

  [[nodiscard]] std::string rendered(bool color) const {
    return grammar::render_text(diagnostics.sorted(), sources, color);
  }

  grammar::Sources sources;
  grammar::Diagnostics diagnostics;
  std::uint32_t file;
  Resolver resolver;
};

}  // namespace

CompiledFormula compile_formula(std::string_view text, const automata::Plant& plant, std::string_view where,
                                bool color) {
  Argument argument(text, plant, where);
  CompiledFormula result;
  if (const auto constraint = grammar::parse_constraint(argument.sources, argument.file, argument.diagnostics)) {
    result.formula = argument.resolver.resolve(*constraint);
  }
  if (argument.diagnostics.has_errors()) result = {std::nullopt, argument.rendered(color)};
  return result;
}

CompiledAssignments compile_assignments(std::string_view text, const automata::Plant& plant, std::string_view where,
                                        bool color) {
  Argument argument(text, plant, where);
  std::vector<automata::Assignment> assignments;
  if (const auto texts = grammar::parse_assignments(argument.sources, argument.file, argument.diagnostics)) {
    for (const grammar::AssignmentText& one : *texts) {
      if (const auto assignment = argument.resolver.assignment(one.variable, one.value)) {
        assignments.push_back(*assignment);
      }
    }
  }
  if (argument.diagnostics.has_errors()) return {std::nullopt, argument.rendered(color)};
  return {std::move(assignments), {}};
}

CompiledProperties compile_properties(const std::string& path, const automata::Plant& plant, bool color) {
  grammar::Sources sources;
  grammar::Diagnostics diagnostics;
  const std::uint32_t file = sources.add(path == "-" ? "standard input" : path, read_text(path));
  CompiledProperties result;
  if (const auto tree = grammar::parse_properties(sources, file, diagnostics)) {
    result.properties = lower_properties(sources, *tree, plant, diagnostics);
  }
  if (diagnostics.has_errors()) return {std::nullopt, grammar::render_text(diagnostics.sorted(), sources, color)};
  return result;
}

}  // namespace rmpl::compiler
