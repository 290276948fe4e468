// Names of figures, and which drawing is whose.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/figures.hpp"

#include <algorithm>
#include <set>

#include "compiler/diagram/component_diagram.hpp"
#include "compiler/diagram/model_diagram.hpp"
#include "compiler/diagram/plant_diagram.hpp"
#include "compiler/diagram/program_diagram.hpp"

namespace rmpl::compiler {
namespace {

void add_types(const automata::Plant& plant, std::vector<Figure>& figures) {
  std::set<std::string_view> seen;
  for (const automata::Component& component : plant.components) {
    if (!seen.insert(component.type).second) continue;
    figures.push_back({Figure::Kind::type, component.type, nullptr, &plant, &component, nullptr});
  }
}

void add_modules(const automata::Plant& plant, std::vector<Figure>& figures) {
  std::set<std::string> seen;
  for (const automata::Component& component : plant.components) {
    for (std::size_t dot = component.name.find('.'); dot != std::string::npos;
         dot = component.name.find('.', dot + 1)) {
      const std::string path = component.name.substr(0, dot);
      if (seen.insert(path).second) figures.push_back({Figure::Kind::module, path, nullptr, &plant, nullptr, nullptr});
    }
  }
}

}  // namespace

std::vector<Figure> figures_of(const automata::Document& document) {
  std::vector<Figure> figures;
  for (const automata::Program& program : document.programs) {
    figures.push_back({Figure::Kind::program, program.name, &program, nullptr, nullptr, nullptr});
  }
  for (const automata::ModelProgram& model : document.models) {
    figures.push_back({Figure::Kind::program, model.name, nullptr, nullptr, nullptr, &model});
  }
  for (const automata::Plant& plant : document.plants) {
    if (!plant.name.empty()) figures.push_back({Figure::Kind::plant, plant.name, nullptr, &plant, nullptr, nullptr});
    add_types(plant, figures);
    add_modules(plant, figures);
    for (const automata::Component& component : plant.components) {
      figures.push_back({Figure::Kind::instance, component.name, nullptr, &plant, &component, nullptr});
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
