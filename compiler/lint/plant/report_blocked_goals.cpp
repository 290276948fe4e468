// Told: which goals of the programs a fault blocks.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/plant/report.hpp"
#include "compiler/lint/program/bound_programs.hpp"

namespace rmpl::compiler {

using automata::ComponentId;
using automata::ModeId;

void report_blocked_goals(PlantReport& report) {
  const automata::Plant& plant = report.plant();
  std::map<automata::VariableId, ComponentId> component_of;
  for (std::size_t c = 0; c < plant.components.size(); ++c)
    component_of.emplace(plant.components[c].mode, ComponentId(c));
  std::map<PlantMode, grammar::Span> asked;  // where it is asked for first
  for (const BoundProgram& bound : bound_programs(report.input())) {
    if (bound.plant != &plant) continue;
    for (std::size_t l = 0; l < bound.program.locations.size(); ++l) {
      for (const automata::Assignment& goal : bound.program.locations[l].goal) {
        const auto component = component_of.find(goal.variable);
        if (component == component_of.end()) continue;
        const PlantMode mode{component->second, ModeId(goal.value.index())};
        if (!plant[mode.component].modes[mode.mode.index()].fault)
          asked.emplace(mode, span_of(report.input(), bound, automata::LocationId(l)));
      }
    }
  }
  if (asked.empty()) return;
  std::vector<PlantMode> goals;
  goals.reserve(asked.size());
  for (const auto& [goal, span] : asked) goals.push_back(goal);
  std::map<PlantMode, std::vector<PlantMode>> by_fault;
  for (const BlockedGoal& blocked : find_blocked_goals(report.analysis(), goals)) {
    by_fault[blocked.fault].push_back(blocked.goal);
  }
  constexpr std::size_t shown = 4;
  for (const auto& [fault, blocked] : by_fault) {
    // That a broken thing does not do what it is for goes without saying.
    const bool reaches_further = std::any_of(blocked.begin(), blocked.end(), [&fault = fault](const PlantMode& goal) {
      return goal.component != fault.component;
    });
    if (!reaches_further) continue;
    std::vector<std::string> names;
    for (const PlantMode& goal : blocked) {
      const automata::Component& component = plant[goal.component];
      names.push_back(backquoted(component.name + " = " + component.modes[goal.mode.index()].name));
    }
    auto& finding = report.add(grammar::Code::fault_blocks_goal, report.at(fault),
                               "the fault " + report.mode(fault) + " of " + report.name({fault.component}) +
                                   " blocks " + (names.size() == 1 ? "the goal " : "the goals ") +
                                   enumerated(names, shown) + ": no transitions lead there any more");
    for (std::size_t g = 0; g < blocked.size() && g < shown; ++g) {
      finding.notes.push_back({asked.at(blocked[g]), "this step asserts " + names[g]});
    }
  }
}

}  // namespace rmpl::compiler
