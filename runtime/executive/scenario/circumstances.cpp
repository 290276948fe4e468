// Modes, readings and places.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/circumstances.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "automata/assignment_text.hpp"
#include "automata/place.hpp"

namespace rmpl::runtime {
namespace {

/// `first, second, …`
std::string listed(const std::vector<std::string>& parts, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(parts.size(), most); ++i) text += (i == 0 ? "" : ", ") + parts[i];
  return parts.size() > most ? text + ", …" : text;
}

}  // namespace

std::string circumstances(const automata::Formula& formula, const CycleRecord& record, const automata::Plant& plant,
                          bool truth) {
  const automata::Modes& modes = truth && record.truth != nullptr ? *record.truth : record.estimate;
  const std::vector<automata::VariableId> mentioned = variables_of(formula);
  std::vector<std::string> parts;
  std::vector<std::string> owners;  // of readings that are told though nobody mentions them
  for (const automata::VariableId variable : mentioned) {
    const auto component = plant.component_of(variable);
    if (!component) continue;
    const automata::Component& told = plant[*component];
    parts.push_back(to_text(told, modes[component->index()]));
    owners.push_back(told.name + ".");
  }
  for (const automata::Assignment& reading : record.observations) {
    const std::string& name = plant.variables.name(reading.variable);
    const bool told = std::find(mentioned.begin(), mentioned.end(), reading.variable) != mentioned.end() ||
                      std::any_of(owners.begin(), owners.end(),
                                  [&](const std::string& owner) { return std::string_view(name).starts_with(owner); });
    if (told) parts.push_back(to_text(plant.variables, reading));
  }
  return listed(parts, 4);
}

std::string places(const automata::Marking& marking, const automata::Program& program) {
  std::vector<std::string> parts;
  for (const automata::LocationId id : marking) {
    const automata::Location& location = program.locations[id.index()];
    if (!location.composite) parts.push_back(location.label + in_parentheses(location.origin));
  }
  return listed(parts, 2);
}

std::string deed(const CycleRecord& record, const automata::Plant& plant) {
  if (record.cycle == 0) return {};
  std::string what = to_text(plant.variables, automata::commanded(plant, record.command));
  if (what.empty() && record.outcome == Reconfiguration::Outcome::wait) what = "a wait";
  if (what.empty() && record.outcome == Reconfiguration::Outcome::no_plan) what = "no plan";
  const std::string why = what.empty() ? "" : to_text(record.why, plant, record.goals.formula());
  return "cycle " + std::to_string(record.cycle) + (what.empty() ? "" : ": ") + what + (why.empty() ? "" : " ") + why;
}

}  // namespace rmpl::runtime
