// Names of figures, and which drawing is whose.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/figures.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "compiler/diagram/component_diagram.hpp"
#include "compiler/diagram/model_diagram.hpp"
#include "compiler/diagram/own_names.hpp"
#include "compiler/diagram/plant_diagram.hpp"
#include "compiler/diagram/program_diagram.hpp"

namespace rmpl::compiler {
namespace {

void add_types(const automata::Plant& plant, std::vector<Figure>& figures) {
  std::set<std::string_view> seen;
  for (const automata::Component& component : plant.components) {
    if (!seen.insert(component.type).second) continue;
    figures.push_back({Figure::Kind::type, component.type, nullptr, &plant, &component});
  }
}

/// The modules that hold the instance, each once.
void add_modules(const std::string& instance, const Figure& inside, std::set<std::string>& seen,
                 std::vector<Figure>& figures) {
  for (std::size_t dot = instance.find('.'); dot != std::string::npos; dot = instance.find('.', dot + 1)) {
    Figure module = inside;
    module.kind = Figure::Kind::module;
    module.name = instance.substr(0, dot);
    if (seen.insert(module.name).second) figures.push_back(std::move(module));
  }
}

void add_plant(const automata::Plant& plant, const automata::PlantWithModels* whole, std::vector<Figure>& figures) {
  Figure all{Figure::Kind::plant, plant.name, nullptr, &plant};
  all.whole = whole;
  if (!plant.name.empty()) figures.push_back(all);
  add_types(plant, figures);
  std::set<std::string> modules;
  std::vector<Figure> types, instances;
  for (const automata::Component& component : plant.components) {
    add_modules(component.name, all, modules, figures);
    instances.push_back({Figure::Kind::instance, component.name, nullptr, &plant, &component});
  }
  if (whole != nullptr) {
    std::set<std::string_view> seen;
    for (const automata::ModelComponent& model : whole->models) {
      Figure held = all;
      held.held = &model;
      held.kind = Figure::Kind::type;
      held.name = model.program.name;
      if (seen.insert(model.program.name).second) types.push_back(held);
      add_modules(model.name, all, modules, figures);
      held.kind = Figure::Kind::instance;
      held.name = model.name;
      instances.push_back(held);
    }
  }
  std::move(types.begin(), types.end(), std::back_inserter(figures));
  std::move(instances.begin(), instances.end(), std::back_inserter(figures));
}

/// The plant with a block for each model program, whose own constraints stay inside.
automata::Plant blocks_of(const automata::PlantWithModels& whole) {
  automata::Plant plant = whole.plant;
  for (const automata::ModelComponent& model : whole.models) {
    std::erase_if(plant.interconnections, [&](const automata::Interconnection& q) {
      const auto variables = automata::variables_of(q.constraint);
      return !variables.empty() && std::all_of(variables.begin(), variables.end(), [&](automata::VariableId v) {
        return is_of(plant.variables.name(v), model.name);
      });
    });
    automata::Component& block = plant.components.emplace_back();
    block.name = model.name;
    block.type = "model " + model.program.name;
    block.mode = plant.variables.add({model.name, {}});
  }
  return plant;
}

/// The program with its names relative to itself.
automata::ModelProgram named_by_itself(const automata::ModelComponent& model, const automata::Plant& plant) {
  automata::ModelProgram program = model.program;
  program.variables = own_names(plant, model.name);
  return program;
}

}  // namespace

std::vector<Figure> figures_of(const automata::Document& document, const PlantsWithModels& plants) {
  std::vector<Figure> figures;
  for (const automata::Program& program : document.programs) {
    figures.push_back({Figure::Kind::program, program.name, &program});
  }
  for (const automata::ModelProgram& model : document.models) {
    figures.push_back({Figure::Kind::program, model.name, nullptr, nullptr, nullptr, &model});
  }
  for (std::size_t p = 0; p < document.plants.size(); ++p) {
    const auto whole = plants.find(p);
    if (whole == plants.end()) {
      add_plant(document.plants[p], nullptr, figures);
    } else {
      add_plant(whole->second.plant, &whole->second, figures);
    }
  }
  return figures;
}

std::vector<Figure> main_figures(const std::vector<Figure>& figures) {
  std::vector<Figure> whole;
  std::vector<Figure> types;
  for (const Figure& figure : figures) {
    if (figure.kind <= Figure::Kind::plant) whole.push_back(figure);
    if (figure.kind == Figure::Kind::type) types.push_back(figure);
  }
  return whole.empty() ? types : whole;
}

std::vector<Figure> named(const std::vector<Figure>& figures, std::string_view name) {
  std::vector<Figure> found;
  for (const Figure& figure : figures) {
    if (figure.name != name) continue;
    if (!found.empty() && figure.kind < found.front().kind) found.clear();
    if (found.empty() || figure.kind == found.front().kind) found.push_back(figure);
  }
  return found;
}

std::string_view to_string(Figure::Kind kind) {
  switch (kind) {
    case Figure::Kind::program:
      return "program";
    case Figure::Kind::plant:
      return "plant";
    case Figure::Kind::type:
      return "component";
    case Figure::Kind::module:
      return "module";
    case Figure::Kind::instance:
      return "instance";
  }
  return {};
}

std::string to_dot(const Figure& figure, std::optional<std::size_t> depth) {
  if (figure.held != nullptr) return model_diagram(named_by_itself(*figure.held, *figure.plant), depth);
  if (figure.whole != nullptr) {
    const std::string inside = figure.kind == Figure::Kind::module ? figure.name : "";
    return plant_diagram(blocks_of(*figure.whole), inside, depth);
  }
  switch (figure.kind) {
    case Figure::Kind::program:
      return figure.model != nullptr ? model_diagram(*figure.model, depth) : program_diagram(*figure.program, depth);
    case Figure::Kind::plant:
      return plant_diagram(*figure.plant, {}, depth);
    case Figure::Kind::module:
      return plant_diagram(*figure.plant, figure.name, depth);
    case Figure::Kind::type:
      return component_diagram(*figure.plant, *figure.component, figure.name, "component");
    case Figure::Kind::instance:
      return component_diagram(*figure.plant, *figure.component, figure.name, figure.component->type);
  }
  return {};
}

}  // namespace rmpl::compiler
