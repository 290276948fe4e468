// Everything of an automaton stands in its picture, once and in its place.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "compiler/diagram/component_diagram.hpp"
#include "compiler/diagram/plant_diagram.hpp"
#include "compiler/diagram/program_diagram.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/drawing.hpp"
#include "tests/property/generate.hpp"

namespace rmpl::property {
namespace {

using automata::LocationId;
using automata::VariableId;

std::string numbered(const char* letter, std::size_t position) { return letter + std::to_string(position + 1); }

/// The clusters around a location, the graph first.
std::vector<std::string> boxes_around(const automata::Program& program, LocationId location) {
  std::vector<std::string> boxes;
  for (auto at = program.locations[location.index()].parent; at; at = program.locations[at->index()].parent) {
    boxes.push_back(numbered("l", at->index()));
  }
  boxes.emplace_back("graph");
  std::reverse(boxes.begin(), boxes.end());
  return boxes;
}

/// What a location is drawn as where `depth` levels are opened.
LocationId seen_as(const automata::Program& program, LocationId location, std::size_t depth) {
  std::vector<LocationId> path{location};
  while (const auto parent = program.locations[path.back().index()].parent) path.push_back(*parent);
  return path[path.size() - 1 - std::min(depth, path.size() - 1)];
}

/// The location that the end of an arrow lies at or in: a node or dot of it or of something inside it.
bool lies_in(const automata::Program& program, const std::string& node, LocationId location) {
  std::optional<LocationId> at(LocationId(std::stoul(node.substr(1)) - 1));
  while (at && *at != location) at = program.locations[at->index()].parent;
  return at.has_value();
}

RC_GTEST_PROP(Diagram, HasEachLocationAndArcOnce, ()) {
  const Model model = *models();
  const automata::Program program = (*programs(model.plant)).program;
  const std::size_t depth = up_to(0, 4);
  const bool whole = chance(50);
  const std::string text = compiler::program_diagram(program, whole ? std::nullopt : std::optional(depth));
  RC_LOG() << text;
  const Drawing drawing = read_drawing(text);
  RC_ASSERT(drawing.closed && drawing.once);
  const auto seen = [&](LocationId id) { return seen_as(program, id, whole ? program.locations.size() : depth); };
  std::size_t shown = 0;
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    const LocationId id(l);
    const auto& location = program.locations[l];
    const auto as_node = drawing.nodes.find(numbered("l", l));
    const auto as_box = drawing.clusters.find(numbered("l", l));
    RC_ASSERT((as_node != drawing.nodes.end()) + (as_box != drawing.clusters.end()) == (seen(id) == id ? 1 : 0));
    if (as_box != drawing.clusters.end()) RC_ASSERT(location.composite && as_box->second == boxes_around(program, id));
    if (as_node != drawing.nodes.end()) RC_ASSERT(as_node->second == boxes_around(program, id));
    if (seen(id) == id) ++shown;
    const bool started = location.parent && location.start && seen(id) == id;
    RC_ASSERT(drawing.edges.contains(numbered("start_", l)) == started);
    for (std::size_t a = 0; a < location.arcs.size(); ++a) {
      const LocationId target = location.arcs[a].target;
      const auto edges = drawing.edges.find(numbered("arc_", l) + numbered("_", a));
      const bool inside = seen(id) == seen(target) && !(seen(id) == id && seen(target) == target);
      RC_ASSERT((edges == drawing.edges.end()) == inside);
      if (inside) continue;
      RC_ASSERT(edges->second.size() == 1u);
      RC_ASSERT(lies_in(program, edges->second[0].from, seen(id)));
      const std::string head = edges->second[0].to.substr(1);
      RC_ASSERT(head == numbered("", seen(target).index()));
    }
  }
  // Besides the locations there are only the dots of the boxes.
  RC_ASSERT(drawing.nodes.size() == shown);
  RC_ASSERT(!drawing.edges.contains(""));
}

/// The numbers in `t1_2_5`, as positions.
std::vector<std::size_t> positions(const std::string& id) {
  std::vector<std::size_t> result;
  std::istringstream numbers(id.substr(1));
  std::string number;
  while (std::getline(numbers, number, '_')) result.push_back(std::stoul(number) - 1);
  return result;
}

RC_GTEST_PROP(Diagram, HasEachModeAndTransitionOnce, ()) {
  const Model model = *models();
  for (const automata::Component& component : model.plant.components) {
    const std::string text = compiler::component_diagram(model.plant, component, component.type, "component");
    RC_LOG() << text;
    const Drawing drawing = read_drawing(text);
    RC_ASSERT(drawing.closed && drawing.once && drawing.clusters.empty());
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      RC_ASSERT(drawing.nodes.contains(numbered("m", m)));
      RC_ASSERT(drawing.edges.contains(numbered("initial_", m)) == (component.initial[m] > 0));
    }
    std::vector<std::size_t> times(component.transitions.size(), 0);
    for (const auto& [id, edges] : drawing.edges) {
      if (id.starts_with("initial")) continue;
      RC_ASSERT(edges.size() == 1u);
      const std::vector<std::size_t> members = positions(id);
      std::vector<std::size_t> sources;
      for (const std::size_t t : members) {
        ++times[t];
        const automata::Transition& transition = component.transitions[t];
        RC_ASSERT(edges[0].to == numbered("m", transition.to.index()));
        RC_ASSERT(transition.guard == component.transitions[members[0]].guard);
        RC_ASSERT(transition.timing == component.transitions[members[0]].timing);
        RC_ASSERT(transition.weight == component.transitions[members[0]].weight);
        sources.push_back(transition.from.index());
      }
      if (members.size() == 1) {
        RC_ASSERT(edges[0].from == numbered("m", sources[0]));
        continue;
      }
      const std::size_t target = component.transitions[members[0]].to.index();
      const bool nominal = text.find(edges[0].from + " [shape=plaintext") != std::string::npos &&
                           text.find("any nominal mode", text.find(edges[0].from + " [")) <
                               text.find('\n', text.find(edges[0].from + " ["));
      std::vector<std::size_t> all;
      for (std::size_t m = 0; m < component.modes.size(); ++m) {
        if (m != target && !(nominal && component.modes[m].fault)) all.push_back(m);
      }
      std::sort(sources.begin(), sources.end());
      RC_ASSERT(sources == all);
    }
    RC_ASSERT(std::all_of(times.begin(), times.end(), [](std::size_t count) { return count == 1; }));
  }
}

/// The plant with its components in modules, and its attributes in components, modules or the plant.
automata::Plant in_modules(automata::Plant plant) {
  const std::vector<std::string> modules{"", "", "left.", "left.inner.", "right."};
  automata::Variables table;
  std::vector<std::string> homes = modules;
  for (automata::Component& component : plant.components) {
    component.name = pick(modules) + component.name;
    homes.push_back(component.name + ".");
  }
  for (std::size_t v = 0; v < plant.variables.size(); ++v) {
    automata::Variable variable = plant.variables[VariableId(v)];
    const auto component = plant.component_of(VariableId(v));
    variable.name = component ? plant[*component].name : pick(homes) + variable.name;
    table.add(std::move(variable));
  }
  plant.variables = std::move(table);
  return plant;
}

/// The first segments of a path, up to `count`.
std::string cut(const std::string& path, std::size_t count) {
  std::size_t end = 0;
  while (count-- > 0 && end != std::string::npos) end = path.find('.', end == 0 ? 0 : end + 1);
  return path.substr(0, end);
}

/// The block of a variable of a whole plant whose modules are opened so deep; nothing for ports of open ones.
std::string block_of(const automata::Plant& plant, VariableId variable, std::size_t depth) {
  const std::string& name = plant.variables.name(variable);
  std::string found;
  for (const automata::Component& component : plant.components) {
    const std::string path = cut(component.name, depth + 1);
    if ((name == path || name.starts_with(path + ".")) && path.size() > found.size()) found = path;
  }
  return found;
}

RC_GTEST_PROP(Diagram, HasEachBlockAndInterconnectionOnce, ()) {
  const automata::Plant plant = in_modules((*models()).plant);
  const std::size_t depth = up_to(0, 2);
  const std::string text = compiler::plant_diagram(plant, "", depth);
  RC_LOG() << text;
  const Drawing drawing = read_drawing(text);
  RC_ASSERT(drawing.closed && drawing.once);
  std::vector<std::string> blocks;
  for (const automata::Component& component : plant.components) blocks.push_back(cut(component.name, depth + 1));
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  for (std::size_t b = 0; b < blocks.size(); ++b) RC_ASSERT(drawing.nodes.contains(numbered("b", b)));
  RC_ASSERT(!drawing.nodes.contains(numbered("b", blocks.size())));
  std::vector<std::size_t> times(plant.interconnections.size(), 0);
  for (const auto& [id, edges] : drawing.edges) {
    if (id.empty()) continue;
    RC_ASSERT(edges.size() == 1u);
    for (const std::size_t q : positions(id)) ++times[q];
  }
  for (const auto& [node, around] : drawing.nodes) {
    if (!node.starts_with("q")) continue;
    for (const std::size_t q : positions(node)) ++times[q];
  }
  for (std::size_t q = 0; q < times.size(); ++q) {
    const auto variables = automata::variables_of(plant.interconnections[q].constraint);
    const std::string first = variables.empty() ? "" : block_of(plant, variables.front(), depth);
    const bool folded = !first.empty() && !plant.find_component(first) &&
                        std::all_of(variables.begin(), variables.end(),
                                    [&](VariableId v) { return block_of(plant, v, depth) == first; });
    RC_ASSERT(times[q] == (folded ? 0u : 1u));
  }
}

}  // namespace
}  // namespace rmpl::property
