// The one public door to text, implemented.
// SPDX-License-Identifier: MIT
#include "compiler/session/compiler.hpp"

#include <cstdint>
#include <utility>

#include "base/check.hpp"
#include "compiler/check/plant_resolver.hpp"
#include "compiler/check/resolve.hpp"
#include "compiler/lower/part.hpp"
#include "compiler/lower/program_resolver.hpp"
#include "compiler/lower/property.hpp"
#include "compiler/session/files.hpp"
#include "compiler/session/input_set.hpp"
#include "compiler/session/names.hpp"
#include "compiler/session/provider.hpp"
#include "grammar/parse/parse.hpp"

namespace rmpl::compiler {

struct Compilation::Result {
  grammar::Findings findings;
  automata::Document document;
  std::vector<automata::PlantProperty> properties;
  std::vector<ProgramPlaces> places, model_places;
  std::map<std::size_t, automata::PlantWithModels> plants_with_models;
  std::map<std::size_t, ProgramPlaces> software_places;
  std::vector<File> files;
};

Compilation::Compilation(std::unique_ptr<Result> result) : result_(std::move(result)) {}
Compilation::Compilation(Compilation&&) noexcept = default;
Compilation& Compilation::operator=(Compilation&&) noexcept = default;
Compilation::~Compilation() = default;

bool Compilation::ok() const { return !result_->findings.diagnostics.has_errors(); }

const automata::Document& Compilation::document() const {
  CHECK(ok() && "a compilation with errors has no document");
  return result_->document;
}

const std::vector<automata::PlantProperty>& Compilation::properties() const {
  CHECK(ok() && "a compilation with errors has no properties");
  return result_->properties;
}

std::span<const ProgramPlaces> Compilation::places() const {
  CHECK(ok() && "a compilation with errors has no programs");
  return result_->places;
}

std::span<const ProgramPlaces> Compilation::model_places() const {
  CHECK(ok() && "a compilation with errors has no model programs");
  return result_->model_places;
}

const std::map<std::size_t, ProgramPlaces>& Compilation::software_places() const {
  CHECK(ok());
  return result_->software_places;
}

const std::map<std::size_t, automata::PlantWithModels>& Compilation::plants_with_models() const {
  return result_->plants_with_models;
}

const grammar::Findings& Compilation::findings() const { return result_->findings; }

std::span<const File> Compilation::files() const { return result_->files; }

void Compilation::forget_files() { result_->files = std::vector<File>(); }

NameIndex Compilation::names() const {
  std::vector<const File*> files;
  for (const File& file : result_->files) files.push_back(&file);
  return index_names(files);
}

Compilation compile(std::span<const std::string> paths, const Options& options) {
  Disk disk;
  return compile(paths, options, disk);
}

Compilation compile(std::span<const std::string> paths, const Options& options, Provider& provider) {
  auto result = std::make_unique<Compilation::Result>();
  InputSet inputs(provider, result->findings.sources, result->findings.diagnostics);
  result->document = inputs.compile(paths, options);
  result->properties = inputs.take_properties();
  result->places = inputs.take_places();
  result->model_places = inputs.take_model_places();
  result->plants_with_models = inputs.take_plants_with_models();
  result->software_places = inputs.take_software_places();
  result->files = inputs.take_files();
  return Compilation(std::move(result));
}

namespace {

/// The resolver of a text of the command line, judged by a plant or a model program.
Resolver resolver_of(const automata::Plant& plant, grammar::Findings& findings) {
  const std::string owner = "plant " + backquoted(plant.name);
  return {{plant.variables, nullptr, owner, grammar::Code::unknown_name, software_of(plant)}, findings.diagnostics};
}

Resolver resolver_of(const automata::ModelProgram& program, grammar::Findings& findings) {
  const std::string owner = "model program " + backquoted(program.name);
  return {{program.variables, nullptr, owner, grammar::Code::unknown_name}, findings.diagnostics};
}

/// `make` makes the resolver, given where findings go.
template <class Make>
CompiledFormula formula_by(std::string_view text, std::string_view where, const Make& make) {
  CompiledFormula result;
  auto& [sources, diagnostics] = result.findings;
  const std::uint32_t file = sources.add(std::string(where), std::string(text));
  const auto constraint = grammar::parse_constraint(sources, file, diagnostics);
  if (constraint.whole) result.formula = make(result.findings).resolve(constraint.tree);
  if (diagnostics.has_errors()) result.formula.reset();
  return result;
}

template <class Model>
CompiledFormula formula_over(std::string_view text, const Model& model, std::string_view where) {
  return formula_by(text, where, [&](grammar::Findings& findings) { return resolver_of(model, findings); });
}

}  // namespace

CompiledFormula compile_formula(std::string_view text, const automata::Plant& plant, std::string_view where) {
  return formula_over(text, plant, where);
}

CompiledFormula compile_program_formula(std::string_view text, const automata::Plant& plant, std::string_view where) {
  return formula_by(text, where, [&](grammar::Findings& findings) {
    PlantResolver resolver(plant, nullptr, findings.diagnostics);
    resolver.ask_of_knowledge(std::nullopt);
    return resolver;
  });
}

CompiledFormula compile_goal(std::string_view text, const automata::Plant& plant, std::string_view where) {
  CompiledFormula result;
  auto& [sources, diagnostics] = result.findings;
  const std::uint32_t file = sources.add(std::string(where), std::string(text));
  const auto constraint = grammar::parse_constraint(sources, file, diagnostics);
  if (constraint.whole) {
    Resolver resolver = resolver_of(plant, result.findings);
    resolver.ask_of_knowledge(goal_asks_no_knowledge);
    result.formula = resolver.resolve(constraint.tree);
  }
  if (!diagnostics.has_errors()) {
    automata::Program program;
    Part part;
    part.plant = plant;
    static_cast<void>(ProgramResolver(program, false, &part, diagnostics).goal(constraint.tree));
  }
  if (diagnostics.has_errors()) result.formula.reset();
  return result;
}

CompiledFormula compile_formula(std::string_view text, const automata::ModelProgram& program, std::string_view where) {
  return formula_over(text, program, where);
}

namespace {

template <class Model>
CompiledAssignments assignments_over(std::string_view text, const Model& model, std::string_view where) {
  CompiledAssignments result;
  auto& [sources, diagnostics] = result.findings;
  const std::uint32_t file = sources.add(std::string(where), std::string(text));
  const auto texts = grammar::parse_assignments(sources, file, diagnostics);
  if (texts.whole) {
    Resolver resolver = resolver_of(model, result.findings);
    auto& assignments = result.assignments.emplace();
    for (const grammar::AssignmentText& one : texts.tree) {
      if (const auto assignment = resolver.assignment(one.variable, one.value)) assignments.push_back(*assignment);
    }
  }
  if (diagnostics.has_errors()) result.assignments.reset();
  return result;
}

}  // namespace

CompiledAssignments compile_assignments(std::string_view text, const automata::Plant& plant, std::string_view where) {
  return assignments_over(text, plant, where);
}

CompiledAssignments compile_assignments(std::string_view text, const automata::ModelProgram& program,
                                        std::string_view where) {
  return assignments_over(text, program, where);
}

CompiledProperties compile_properties(const std::string& path, const automata::Plant& plant, bool under_program) {
  Disk disk;
  return compile_properties(path, plant, under_program, disk);
}

CompiledProperties compile_properties(const std::string& path, const automata::Plant& plant, bool under_program,
                                      Provider& provider) {
  CompiledProperties result;
  auto& [sources, diagnostics] = result.findings;
  const std::uint32_t file = sources.add(path == "-" ? "standard input" : path, provider.read(path));
  const auto properties = grammar::parse_properties(sources, file, diagnostics);
  if (properties.whole)
    result.properties = lower_properties(sources, properties.tree, {file, 0, 0}, plant, under_program, diagnostics);
  if (diagnostics.has_errors()) result.properties.reset();
  return result;
}

}  // namespace rmpl::compiler
