// Instances unfolded once more, for their places.
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/declarations.hpp"

#include <string_view>
#include <variant>

namespace rmpl::compiler {

using grammar::AttributeDeclaration;
using grammar::ComponentDefinition;
using grammar::InstanceDeclaration;
using grammar::ModuleDefinition;
using grammar::Name;

namespace {

class Unfolding {
 public:
  Unfolding(const LintInput& input, const automata::Plant& plant) {
    for (const File& file : input.files) {
      if (file.plant) collect(*file.plant, plant.name);
    }
    if (root_ == nullptr) return;
    result_.plant = root_->name.span;
    unfold("", *root_);
  }
  PlantDeclarations take() { return std::move(result_); }

 private:
  void collect(const grammar::PlantFile& file, const std::string& plant) {
    for (const grammar::PlantItem& item : file.items) {
      if (const auto* component = std::get_if<ComponentDefinition>(&item))
        components_[component->name.text] = component;
      const auto* module = std::get_if<ModuleDefinition>(&item);
      if (module == nullptr) continue;
      if (!module->plant) modules_[module->name.text] = module;
      if (module->plant && module->name.text == plant) root_ = module;
    }
  }

  static std::string within(const std::string& instance, const std::string& name) {
    return instance.empty() ? name : instance + "." + name;
  }

  void add(const std::string& instance, const std::string& type, const AttributeDeclaration& declaration,
           bool of_component) {
    for (const Name& name : declaration.names) {
      result_.attributes.push_back(
          {within(instance, name.text), type, name.text, declaration.direction, name.span, of_component});
    }
  }

  void unfold(const std::string& instance, const ModuleDefinition& module) {
    for (const grammar::ModuleItem& item : module.items) {
      if (const auto* port = std::get_if<AttributeDeclaration>(&item)) add(instance, module.name.text, *port, false);
      if (const auto* control = std::get_if<grammar::Control>(&item)) {
        for (const Name& name : control->names) result_.controls.emplace(within(instance, name.text), name.span);
      }
      const auto* instances = std::get_if<InstanceDeclaration>(&item);
      if (instances == nullptr) continue;
      for (const Name& name : instances->names) unfold(within(instance, name.text), name, instances->type.text);
    }
  }

  void unfold(const std::string& instance, const Name& name, const std::string& type) {
    if (const auto module = modules_.find(type); module != modules_.end()) return unfold(instance, *module->second);
    const auto component = components_.find(type);
    if (component == components_.end()) return;
    result_.instances.emplace(instance, name.span);
    for (const grammar::ComponentItem& item : component->second->items) {
      if (const auto* attribute = std::get_if<AttributeDeclaration>(&item)) add(instance, type, *attribute, true);
    }
  }

  std::map<std::string, const ComponentDefinition*, std::less<>> components_;
  std::map<std::string, const ModuleDefinition*, std::less<>> modules_;
  const ModuleDefinition* root_ = nullptr;
  PlantDeclarations result_;
};

}  // namespace

PlantDeclarations declarations_of(const LintInput& input, const automata::Plant& plant) {
  return Unfolding(input, plant).take();
}

}  // namespace rmpl::compiler
