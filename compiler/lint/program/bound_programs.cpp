// Programs, plants and scenarios that belong together.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/bound_programs.hpp"

#include <algorithm>
#include <utility>

#include "compiler/lint/program/reachable_modes.hpp"

namespace rmpl::compiler {

namespace {

const automata::Plant* plant_of(const automata::Document& document, std::size_t program) {
  for (const automata::Scenario& scenario : document.scenarios) {
    if (scenario.program == program) return &document.plant_of(scenario);
  }
  for (const automata::Plant& plant : document.plants) {
    if (plant.variables == document.programs[program].variables) return &plant;
  }
  return nullptr;
}

}  // namespace

std::vector<BoundProgram> bound_programs(const LintInput& input) {
  std::vector<BoundProgram> all;
  const automata::Document& document = input.document;
  for (std::size_t p = 0; p < document.programs.size(); ++p) {
    BoundProgram bound{document.programs[p], plant_of(document, p), input.programs[p], {}, {}};
    for (const automata::Scenario& scenario : document.scenarios) {
      if (scenario.program != p) continue;
      bound.cycle = std::max(bound.cycle, scenario.cycle);
      const auto added = added_modes(scenario, document.plant_of(scenario));
      bound.also.insert(bound.also.end(), added.begin(), added.end());
    }
    if (bound.cycle == automata::Ticks{0}) bound.cycle = input.cycle;
    all.push_back(std::move(bound));
  }
  return all;
}

grammar::Span span_of(const LintInput& input, const BoundProgram& bound, automata::LocationId location) {
  const auto& spans = bound.places.locations;
  return location.index() < spans.size() ? spans[location.index()]
                                         : input.places.at(bound.program.locations[location.index()].origin);
}

}  // namespace rmpl::compiler
