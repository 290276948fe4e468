// Modules and plants: types lowered once, instances copied, connections resolved.
// SPDX-License-Identifier: MIT
#include "compiler/lower/module.hpp"

#include <algorithm>
#include <utility>

#include "compiler/lower/attributes.hpp"
#include "compiler/lower/component.hpp"
#include "compiler/lower/initial.hpp"
#include "compiler/lower/ports.hpp"

namespace rmpl::compiler {

using grammar::Code;
using grammar::Name;

namespace {

/// Modules in modules in modules: a limit that keeps the lowering, and the names, from growing without end.
constexpr std::size_t module_depth_limit = 200;

}  // namespace

std::optional<Part> ModelLowering::run(const std::vector<const grammar::PlantFile*>& files,
                                       const std::vector<const grammar::ProgramFile*>& programs, grammar::Span blame,
                                       bool types_suffice) {
  for (const grammar::ProgramFile* program : programs) {
    for (const grammar::ProgramItem& item : program->items) {
      if (const auto* domain = std::get_if<grammar::Domain>(&item)) domains_.lend(*domain);
    }
  }
  declare_types(files);
  for (Type* type : order_) lower(*type);
  if (plants_.empty() && types_suffice && !order_.empty()) return instances_of_types();
  if (plants_.empty()) {
    auto& error = diagnostics_.error(Code::no_plant, blame, "the model has no plant");
    error.suggestion = "add `plant Name { … }` with the instances of the model";
    return std::nullopt;
  }
  for (std::size_t p = 1; p < plants_.size(); ++p) {
    auto& error = diagnostics_.error(Code::several_plants, plants_[p]->name.span,
                                     "a second plant, " + backquoted(plants_[p]->name.text) + ", in one model");
    error.notes.push_back(
        {plants_[0]->name.span, "the first plant, " + backquoted(plants_[0]->name.text) + ", is here"});
    error.suggestion = "make one of them a module";
  }
  std::optional<Part> result;
  for (const grammar::ModuleDefinition* plant : plants_) {
    Part part;
    part.plant.name = plant->name.text;
    lower_module(*plant, part);
    const bool unbuildable = std::any_of(plant->items.begin(), plant->items.end(),
                                         [](const grammar::ModuleItem& item) {
                                           return std::holds_alternative<grammar::InstanceDeclaration>(item);
                                         }) &&
                             diagnostics_.error_count() > 0;  // instances of what is wrong leave nothing behind
    const bool empty = part.plant.components.empty() && part.models.empty() && !unbuildable;
    if (empty) {
      diagnostics_.error(
          Code::no_instances, plant->name.span,
          "plant " + backquoted(plant->name.text) + " has no instances, expected at least one component");
    }
    if (!result) result = std::move(part);
  }
  return result;
}

void ModelLowering::declare_types(const std::vector<const grammar::PlantFile*>& files) {
  for (const grammar::PlantFile* file : files) {
    for (const grammar::PlantItem& item : file->items) {
      if (const auto* domain = std::get_if<grammar::Domain>(&item)) domains_.declare(*domain);
    }
  }
  for (const grammar::PlantFile* file : files) {
    for (const grammar::PlantItem& item : file->items) {
      if (const auto* component = std::get_if<grammar::ComponentDefinition>(&item)) {
        declare_type({component->name, component, nullptr, nullptr});
      } else if (const auto* module = std::get_if<grammar::ModuleDefinition>(&item)) {
        if (module->plant) plants_.push_back(module);
        if (!module->plant) declare_type({module->name, nullptr, module, nullptr});
      }
    }
  }
}

void ModelLowering::declare_type(Type type) {
  const Name name = type.name;
  const auto [at, fresh] = types_.emplace(name.text, std::move(type));
  if (fresh) {
    order_.push_back(&at->second);
    return;
  }
  auto& error = diagnostics_.error(
      Code::duplicate_name, name.span,
      (at->second.module != nullptr ? "module " : "component ") + backquoted(name.text) + " is already defined");
  error.notes.push_back({at->second.name.span, backquoted(name.text) + " is first defined here"});
}

const Part* ModelLowering::lower(Type& type) {
  if (type.part) return type.part.get();
  auto part = std::make_unique<Part>();
  if (type.component != nullptr) {
    *part = ComponentLowering(sources_, domains_, diagnostics_).run(*type.component);
  } else {
    type.open = true;
    part->plant.name = type.name.text;
    lower_module(*type.module, *part);
    type.open = false;
    type.too_large = part->size > size_limit;
    if (type.too_large) *part = {};  // what holds it need not grow by it
  }
  type.part = std::move(part);
  return type.part.get();
}

void ModelLowering::lower_module(const grammar::ModuleDefinition& definition, Part& part) {
  Uniqueness names("name", diagnostics_);
  for (const grammar::ModuleItem& item : definition.items) {
    if (const auto* port = std::get_if<grammar::AttributeDeclaration>(&item))
      declare(part, port->names, port->domain, names, domains_, diagnostics_);
  }
  for (const grammar::ModuleItem& item : definition.items) {
    if (const auto* instance = std::get_if<grammar::InstanceDeclaration>(&item)) add_instances(*instance, names, part);
  }
  connect(sources_, definition, part, diagnostics_);
}

void ModelLowering::add_instances(const grammar::InstanceDeclaration& declaration, Uniqueness& names, Part& part) {
  std::vector<const Name*> fresh;
  for (const Name& name : declaration.names) {
    if (names.add(name)) fresh.push_back(&name);
  }
  if (declaration.progress && declaration.model) {
    diagnostics_.error(Code::wrong_kind_of_name, declaration.type.span,
                       "`progress` before model program " + backquoted(declaration.type.text) +
                           ", whose steps no goal has to license");
  }
  if (declaration.model) return add_models(declaration, fresh, part);
  Type* type = find_type(declaration.type);
  if (type == nullptr || type->open) {
    for (const Name* name : fresh) part.broken.insert(name->text);
  }
  if (type == nullptr) return;
  if (type->open) return report_cycle(*type, declaration.type);
  if (path_.size() >= module_depth_limit) {
    diagnostics_.error(Code::nesting_too_deep, declaration.type.span,
                       "modules nest deeper than " + std::to_string(module_depth_limit));
    return;
  }
  path_.emplace_back(type, declaration.type);
  const Part* made = lower(*type);
  path_.pop_back();
  std::optional<std::vector<double>> initial;
  if (declaration.initial && type->module != nullptr) {
    auto& error = diagnostics_.error(
        Code::wrong_kind_of_name, declaration.initial->span,
        "an initial mode for an instance of module " + backquoted(type->name.text) + ", which has no modes");
    error.notes.push_back({type->name.span, backquoted(type->name.text) + " is a module"});
  } else if (declaration.initial) {
    initial = initial_distribution(*declaration.initial, made->plant.components.front(), diagnostics_);
  }
  for (const Name* name : fresh) {
    if (type->too_large) part.broken.insert(name->text);
    add_instance(*name, *made, initial, declaration.progress, part);
  }
}

void ModelLowering::add_models(const grammar::InstanceDeclaration& declaration, const std::vector<const Name*>& fresh,
                               Part& part) {
  if (declaration.initial) {
    diagnostics_.error(
        Code::wrong_kind_of_name, declaration.initial->span,
        "an initial mode for model program " + backquoted(declaration.type.text) + ", which has no modes");
  }
  const Part* made = model_type_(declaration.type);
  for (const Name* name : fresh) {
    if (made == nullptr) {
      part.broken.insert(name->text);
      continue;
    }
    const std::size_t before = part.models.size();
    add_instance(*name, *made, std::nullopt, false, part);
    if (part.models.size() > before) part.models.back().span = name->span;
  }
}

void ModelLowering::add_instance(const Name& name, const Part& type, const std::optional<std::vector<double>>& initial,
                                 bool progress, Part& part) {
  if (const std::string clash = first_clash(part, name.text, type); !clash.empty()) {
    diagnostics_.error(Code::duplicate_name, name.span,
                       "instance " + backquoted(name.text) + " brings the name " + backquoted(clash) +
                           ", which another instance or port has already");
    return;
  }
  if (!make_room(part, type.size, name.span, diagnostics_)) {
    part.broken.insert(name.text);
    return;
  }
  const std::size_t before = part.plant.components.size();
  instantiate(part, name.text, type);
  for (std::size_t c = before; progress && c < part.plant.components.size(); ++c)
    part.plant.components[c].progress = true;
  if (initial) part.plant.components.back().initial = *initial;
}

Part ModelLowering::instances_of_types() {
  Part part;
  for (const Type* type : order_) {
    if (!type->part->plant.components.empty()) add_instance(type->name, *type->part, std::nullopt, false, part);
  }
  return part;
}

ModelLowering::Type* ModelLowering::find_type(const Name& name) {
  if (const auto known = types_.find(name.text); known != types_.end()) return &known->second;
  const auto plant = std::find_if(plants_.begin(), plants_.end(),
                                  [&](const grammar::ModuleDefinition* p) { return p->name.text == name.text; });
  const std::size_t before = diagnostics_.error_count();
  if (plant != plants_.end()) {
    auto& error = diagnostics_.error(Code::wrong_kind_of_name, name.span,
                                     backquoted(name.text) + " is the plant: it has no instances, it is the whole");
    error.notes.push_back({(*plant)->name.span, "the plant is defined here"});
    error.suggestion = "make it a module";
    return nullptr;
  }
  if (!unknown_.insert(name.text).second) return nullptr;
  auto& error =
      diagnostics_.error(Code::unknown_name, name.span, "there is no component or module " + backquoted(name.text));
  std::vector<std::string> candidates;
  for (const Type* type : order_) candidates.push_back(type->name.text);
  suggest(error, before, name.text, candidates);
  return nullptr;
}

void ModelLowering::report_cycle(const Type& type, const Name& instance) {
  // The cycle starts where the type was entered; a module lowered as a root is on no path, and then all of it counts.
  auto first = std::find_if(path_.begin(), path_.end(), [&](const auto& step) { return step.first == &type; });
  std::string cycle = backquoted(type.name.text);
  for (auto step = first == path_.end() ? path_.begin() : std::next(first); step != path_.end(); ++step) {
    cycle += " -> " + backquoted(step->first->name.text);
  }
  auto& error = diagnostics_.error(
      Code::instance_cycle, instance.span,
      "module " + backquoted(type.name.text) + " contains itself: " + cycle + " -> " + backquoted(type.name.text));
  for (auto step = first == path_.end() ? path_.begin() : std::next(first); step != path_.end(); ++step) {
    error.notes.push_back({step->second.span, backquoted(step->first->name.text) + " is instantiated here"});
  }
}

}  // namespace rmpl::compiler
