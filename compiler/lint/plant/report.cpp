// What the texts about plants have in common.
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/report.hpp"

#include <algorithm>

#include "automata/assignment_text.hpp"
#include "base/enumerated.hpp"
#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::ComponentId;

namespace {

constexpr std::size_t few = 6;

}  // namespace

PlantReport::PlantReport(const LintInput& input, const automata::Plant& plant, grammar::Diagnostics& found)
    : input_(input),
      plant_(plant),
      found_(found),
      analysis_(plant),
      declarations_(declarations_of(input, plant)),
      undriven_(undriven_inputs(plant, declarations_)),
      removals_(input.sources) {}

grammar::Span PlantReport::at(PlantMode mode) const {
  return at(plant_[mode.component].modes[mode.mode.index()].origin);
}

grammar::Span PlantReport::at(PlantTransition transition) const { return at((*this)[transition].origin); }

bool PlantReport::all(const std::vector<ComponentId>& instances) const {
  return instances.size() == analysis_.instances_of(plant_[instances.front()].type).size();
}

std::string PlantReport::name(const std::vector<ComponentId>& instances) const {
  if (all(instances)) return backquoted(plant_[instances.front()].type);
  std::vector<std::string> names;
  names.reserve(instances.size());
  for (const ComponentId instance : instances) names.push_back(backquoted(plant_[instance].name));
  return enumerated(names, 3);
}

std::string PlantReport::mode(PlantMode mode) const {
  return backquoted(plant_[mode.component].modes[mode.mode.index()].name);
}

std::string PlantReport::list(const std::vector<Assignment>& assignments) const {
  std::vector<std::string> texts;
  texts.reserve(assignments.size());
  for (const Assignment& a : assignments) {
    texts.push_back(backquoted(to_text(plant_.variables, a)));
  }
  return enumerated(texts, few);
}

void PlantReport::blame(grammar::Diagnostic& finding, const Contradiction& contradiction) const {
  const automata::PlantIndex& index = analysis_.index();
  std::size_t told = 0;
  for (const std::size_t q : contradiction.interconnections) {
    if (++told > few) break;
    finding.notes.push_back(
        {at(plant_.interconnections[q].origin), "this interconnection is part of the contradiction"});
  }
  for (const Assignment& a : contradiction.assumed) {
    const auto component = index.component_of(a.variable);
    if (!component) continue;
    const automata::Mode& mode = plant_[*component].modes[a.value.index()];
    finding.notes.push_back({at(mode.origin), "mode " + backquoted(mode.name) + " of " +
                                                  backquoted(plant_[*component].name) +
                                                  " is part of the contradiction"});
  }
  std::map<ComponentId, std::vector<std::string>> never;
  for (const Assignment& a : contradiction.never) {
    const ComponentId component = *index.component_of(a.variable);
    never[component].push_back(backquoted(plant_[component].modes[a.value.index()].name));
  }
  for (const auto& [component, modes] : never) {
    if (++told > 2 * few) break;
    finding.notes.push_back({at(plant_[component].origin), "so is the fact that " + backquoted(plant_[component].name) +
                                                               " is never in " + enumerated(modes, few)});
  }
}

std::string enumerated(const std::vector<std::string>& names, std::size_t limit) {
  const std::size_t shown = names.size() > limit + 1 ? limit : names.size();
  std::vector<std::string> told(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown));
  if (shown < names.size()) told.push_back(std::to_string(names.size() - shown) + " more");
  return base::enumerated(told);
}

}  // namespace rmpl::compiler
