// Scenarios of an input set, and the files that they name.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lower/scenario.hpp"
#include "compiler/session/input_set.hpp"

namespace rmpl::compiler {

using grammar::Code;
using grammar::Span;

void InputSet::scenarios(const File& file) {
  if (!file.whole) return;
  if (file.scenarios->scenarios.empty()) {
    auto& error = diagnostics_.error(Code::scenario_missing_part, {file.index, 0, 0}, "the file has no scenario");
    error.suggestion = "add `scenario \"name\" { … }`";
  }
  std::map<std::string, Span> names;
  for (const grammar::ScenarioDefinition& definition : file.scenarios->scenarios) {
    const auto [first, fresh] = names.emplace(definition.name.text, definition.name.span);
    if (!fresh) {
      auto& error = diagnostics_.error(Code::duplicate_name, definition.name.span,
                                       "scenario \"" + definition.name.text + "\" is already defined");
      error.notes.push_back({first->second, "it is first defined here"});
    }
    const ScenarioFiles parts = files_of(definition, diagnostics_);
    const Plant plant = parts.plant == nullptr ? Plant{} : flown(file, *parts.plant);
    automata::Scenario scenario = lower_scenario(sources_, definition, plant.part, diagnostics_);
    const bool sampled = std::any_of(definition.items.begin(), definition.items.end(), [](const auto& item) {
      return std::holds_alternative<grammar::ChannelEvent>(item);
    });
    if (sampled) {
      const automata::Plant* flown = plant.part == nullptr ? nullptr : &plant.part->plant;
      sampled_.push_back({&definition, definition.name.span, flown, std::nullopt});
    }
    Program program;
    if (const File* from = parts.program == nullptr ? nullptr : controlling(file, parts.program->path)) {
      Entry entry;
      if (parts.program->main) entry = {parts.program->main->text, parts.program->main->span};
      program = this->program({from}, entry, plant.part, parts.program->path.span);
      if (program.model) {
        diagnostics_.error(
            Code::no_program, parts.program->path.span,
            backquoted(parts.program->path.text) + " is a model program: a scenario flies one that controls");
      }
    }
    if (plant.part == nullptr || !program.position) continue;
    scenario.plant = plant.position;
    scenario.program = *program.position;
    if (sampled) sampled_.back().scenario = document_.scenarios.size();
    document_.scenarios.push_back(std::move(scenario));
  }
}

InputSet::Plant InputSet::flown(const File& scenarios, const grammar::PlantPart& part) {
  const grammar::String& path = part.path;
  const File* file = files_.open(scenarios, path);
  if (file == nullptr) return {};
  const auto report_no_plant = [&] {
    diagnostics_.error(Code::no_plant, path.span, backquoted(path.text) + " holds no plant");
  };
  Plant result;
  if (file->kind == Kind::program) {
    Entry entry;
    if (part.main) entry = {part.main->text, part.main->span};
    const Program software = program({file}, entry, nullptr, path.span);
    if (software.position) report_no_plant();
    if (!software.model) return {};
    result = alone(*software.model, software.declared, path.span);
  } else if (file->kind == Kind::plant || file->kind == Kind::document) {
    if (part.main) {
      diagnostics_.error(Code::wrong_kind_of_name, part.main->span,
                         "`main` names a definition of a model program, and " + backquoted(path.text) + " is a plant");
    }
    const automata::Document* compiled = file->document ? &*file->document : nullptr;
    const bool software = compiled != nullptr && compiled->plants.empty() && compiled->models.size() == 1;
    result = software ? alone(*file, path.span) : plant({file}, path.span);
  } else {
    report_no_plant();
  }
  return result;
}

const File* InputSet::controlling(const File& scenarios, const grammar::String& path) {
  const File* file = files_.open(scenarios, path);
  if (file == nullptr || file->kind == Kind::program || file->kind == Kind::document) return file;
  diagnostics_.error(Code::no_program, path.span, backquoted(path.text) + " holds no control program");
  return nullptr;
}

}  // namespace rmpl::compiler
