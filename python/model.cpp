// Compilation, and what of it has a name.
// SPDX-License-Identifier: MIT
#include "python/model.hpp"

#include <algorithm>

#include "automata/json/document.hpp"
#include "base/error.hpp"
#include "compiler/diagram/figures.hpp"
#include "compiler/session/contents.hpp"
#include "compiler/session/provider.hpp"
#include "grammar/source/render.hpp"
#include "python/errors.hpp"
#include "runtime/executive/trace/json_line.hpp"

namespace rmpl::python {
namespace {

compiler::Compilation compiled(const std::vector<std::string>& files, const std::map<std::string, std::string>& texts,
                               const std::string& main) {
  compiler::Disk disk;
  compiler::Overlay sources(disk);
  for (const auto& [path, text] : texts) sources.put(path, text);
  compiler::Compilation compilation =
      compiler::compile(files, {.main = main, .monitors = true, .types_suffice = true}, sources);
  if (!compilation.ok()) reject(compilation.findings());
  compilation.forget_files();
  return compilation;
}

std::string joined(const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files) text += (text.empty() ? "" : ", ") + file;
  return text;
}

template <class Things>
void put_names(runtime::JsonLine& json, std::string_view key, const Things& things) {
  json.key(key).open('[');
  for (const auto& thing : things) json.string(thing.name);
  json.close(']');
}

}  // namespace

Model::Model(const std::vector<std::string>& files, const std::map<std::string, std::string>& texts,
             const std::string& main)
    : paths_(joined(files)), compilation_(compiled(files, texts, main)) {}

const automata::Plant& Model::plant() const { return compiler::only_plant(document(), paths_); }

const automata::ModelProgram& Model::model_program() const { return compiler::only_model_program(document(), paths_); }

const automata::Scenario& Model::scenario(const std::optional<std::string>& name) const {
  const std::vector<automata::Scenario>& all = document().scenarios;
  if (!name && all.size() == 1) return all.front();
  std::string names;
  for (const automata::Scenario& one : all) {
    if (name && one.name == *name) return one;
    names += (names.empty() ? "'" : ", '") + one.name + "'";
  }
  if (all.empty()) throw base::InputError(paths_ + ": there is no scenario, and a flight is one of a .scn file");
  if (name) throw base::InputError(paths_ + ": no scenario is called '" + *name + "'; there are " + names);
  throw base::InputError(paths_ + ": expected one scenario, and there are several: choose one of " + names);
}

std::string Model::diagnostics() const { return grammar::render_json(compilation_.findings()); }

std::string Model::names() const {
  runtime::JsonLine json;
  json.open('{');
  put_names(json, "plants", document().plants);
  put_names(json, "programs", document().programs);
  put_names(json, "models", document().models);
  put_names(json, "scenarios", document().scenarios);
  json.close('}');
  return json.text();
}

std::string Model::text() const { return automata::to_text(document()); }

std::string Model::dot(const std::string& of, std::optional<std::size_t> depth) const {
  const auto figures = compiler::figures_of(document(), compilation_.plants_with_models());
  const auto asked = of.empty() ? compiler::main_figures(figures) : compiler::named(figures, of);
  if (asked.empty()) {
    throw base::InputError(paths_ +
                           (of.empty() ? ": there is nothing to draw" : ": there is nothing called '" + of + "'"));
  }
  std::string graph = to_dot(asked.front(), depth);
  const bool alike = std::all_of(asked.begin() + 1, asked.end(),
                                 [&](const compiler::Figure& other) { return to_dot(other, depth) == graph; });
  if (alike) return graph;
  std::string names;
  for (const compiler::Figure& figure : asked) names += (names.empty() ? "'" : ", '") + figure.name + "'";
  throw base::InputError(paths_ + ": there are several figures: name one of " + names);
}

automata::Formula Model::goal(const std::string& text, const std::string& where) const {
  auto compiled = compiler::compile_goal(text, plant(), where);
  if (!compiled.formula) reject(compiled.findings);
  return *std::move(compiled.formula);
}

std::vector<automata::Assignment> Model::assignments(const std::string& text, const std::string& where) const {
  auto compiled = compiler::compile_assignments(text, plant(), where);
  if (!compiled.assignments) reject(compiled.findings);
  return compiler::each_once(*std::move(compiled.assignments), plant().variables, where);
}

automata::Ticks duration(const std::string& text, const std::string& where) {
  if (const auto ticks = automata::parse_duration(text)) return *ticks;
  throw base::InputError(where + ": '" + text +
                         "' is no duration; expected seconds, or a number with a unit, as in '90 s' or '1.5 h'");
}

}  // namespace rmpl::python
