// The model programs of an input set: as plants by themselves, and as components of plants.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "automata/software/as_components.hpp"
#include "base/limit_error.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/session/input_set.hpp"

namespace rmpl::compiler {

using grammar::Code;
using grammar::Span;

InputSet::Roots InputSet::beside_control(Roots& programs) const {
  const auto is_model = [](const File* file) {
    if (!file->program) return false;
    const auto& items = file->program->items;
    return std::any_of(items.begin(), items.end(), [](const grammar::ProgramItem& item) {
      const auto* definition = std::get_if<grammar::Definition>(&item);
      return definition != nullptr ? definition->model : std::holds_alternative<grammar::VariableDeclaration>(item);
    });
  };
  const auto control = std::stable_partition(programs.begin(), programs.end(), is_model);
  if (control == programs.end() && adopted_.empty()) return {};
  Roots models(programs.begin(), control);
  programs.erase(programs.begin(), control);
  return models;
}

InputSet::Plant InputSet::alone(const Roots& roots, const Entry& entry, Span blame) {
  const Program software = program(roots, entry, nullptr, blame);
  return software.model ? alone(*software.model, software.declared, blame) : Plant{};
}

InputSet::Plant InputSet::alone(const File& document, Span blame) {
  if (const auto known = plants_.find({&document}); known != plants_.end()) return known->second;
  const std::size_t model = document_.models.size();
  document_.models.push_back(document.document->models.front());
  model_places_.emplace_back();
  return plants_.emplace(Roots{&document}, alone(model, {}, blame)).first->second;
}

InputSet::Plant InputSet::alone(std::size_t model, const std::vector<Span>& declared, Span blame) {
  const auto [known, fresh] = alone_.try_emplace(model);
  if (!fresh) return known->second;
  automata::PlantWithModels whole = automata::plant_of(document_.models[model]);
  Part part{std::move(whole.plant), declared, {}, 0};
  part.declared.resize(part.plant.variables.size(), blame);
  part.models.push_back({std::move(whole.models.front()), blame});
  const std::size_t position = document_.plants.size();
  if (!lower_software(part, position)) return known->second;
  with_models_.erase(position);  // the program stands by itself
  software_places_.erase(position);
  document_.plants.emplace_back();
  return known->second = {position, &add_part(position, std::move(part))};
}

bool InputSet::lower_software(Part& part, std::size_t position) {
  automata::PlantWithModels& whole = with_models_[position];
  whole.plant = std::move(part.plant);
  const Span first = part.models.front().span;
  std::vector<std::pair<std::string, Span>> instances;
  for (ModelPart& model : part.models) {
    instances.emplace_back(model.component.name, model.span);
    auto& conditions = software_places_[position].conditions;
    conditions.insert(conditions.end(), model.conditions.begin(), model.conditions.end());
    whole.models.push_back(std::move(model.component));
  }
  part.models.clear();
  try {
    part.plant = automata::with_software(whole).plant;
  } catch (const base::LimitError& limit) {
    auto& error = diagnostics_.error(Code::too_much_software, first, limit.what());
    error.suggestion = "take the definition apart: what stands side by side in it may be instances of their own";
    with_models_.erase(position);
    return false;
  }
  for (std::size_t v = part.declared.size(); v < part.plant.variables.size(); ++v) {
    const std::string& name = part.plant.variables.name(automata::VariableId(v));
    const auto is_of = [&](const auto& instance) {
      return name == instance.first || name.starts_with(instance.first + ".");
    };
    const auto instance = std::find_if(instances.begin(), instances.end(), is_of);
    part.declared.push_back(instance == instances.end() ? first : instance->second);
  }
  return true;
}

const Part* InputSet::model_type(const std::vector<const File*>& files, const grammar::Name& definition) {
  for (const File* file : files) {
    const auto [known, fresh] = model_types_.try_emplace({file, definition.text});
    if (!fresh && known->second) return &*known->second;
    const auto defines = [&](const grammar::ProgramItem& item) {
      const auto* found = std::get_if<grammar::Definition>(&item);
      return found != nullptr && found->name.text == definition.text;
    };
    const FileSet set = files_.with_imports({file});
    const bool here = std::any_of(set.files.begin(), set.files.end(), [&](const File* one) {
      return one->program && std::any_of(one->program->items.begin(), one->program->items.end(), defines);
    });
    if (!here) continue;
    if (!fresh || !set.complete) return nullptr;  // reported
    std::vector<ProgramSource> sources;
    for (const File* one : set.files) sources.push_back({&*one->program, true});
    const std::size_t errors = diagnostics_.error_count();
    Lowered lowered = lower_definitions(sources, {definition.text, definition.span}, nullptr, definition.span);
    if (lowered.program && diagnostics_.error_count() == errors) {
      diagnostics_.error(Code::wrong_kind_of_name, definition.span,
                         backquoted(definition.text) + " is a control program, expected one that begins with `model`");
    }
    if (!lowered.model || diagnostics_.error_count() != errors) return nullptr;
    Part& part = known->second.emplace();
    part.plant.name = definition.text;
    part.plant.variables = lowered.model->variables;
    part.plant.interconnections = lowered.model->constraints;
    part.declared.assign(part.plant.variables.size(), definition.span);
    for (const automata::ModelLocation& location : lowered.model->locations) part.size += 1 + location.functions.size();
    for (const automata::Variable& variable : part.plant.variables) part.size += variable.values.size();
    part.models.push_back(
        {{"", std::move(*lowered.model)}, definition.span, std::move(lowered.model_places.conditions)});
    return &part;
  }
  auto& error = diagnostics_.error(Code::unknown_name, definition.span,
                                   "there is no model program " + backquoted(definition.text) + " in what is imported");
  error.suggestion = "import the file that defines it: `import \"….rmpl\";`";
  return nullptr;
}

}  // namespace rmpl::compiler
