// Told: commands without an effect, or that cannot be; components that no command reaches.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::ComponentId;
using automata::VariableId;
using grammar::Code;

namespace {

grammar::Span declared(const PlantReport& report, VariableId control) {
  const auto& controls = report.declarations().controls;
  const auto known = controls.find(report.plant().variables.name(control));
  return known == controls.end() ? report.declarations().plant : known->second;
}

void report_impossible_commands(PlantReport& report, const std::vector<Assignment>& impossible) {
  for (const Assignment& command : impossible) {
    const Contradiction why = report.analysis().blame().of({&command, 1}, automata::constant(true));
    auto& finding = report.add(
        Code::impossible_command, declared(report, command.variable),
        "the command " + report.list({command}) + " contradicts the model in all modes: no state permits it");
    report.blame(finding, why);
  }
}

/// Once for each control: the first mode that its idle value contradicts.
void report_contradicting_idle(PlantReport& report, const std::vector<Assignment>& impossible) {
  std::set<VariableId> told;
  for (const Assignment& command : impossible) told.insert(command.variable);
  for (const IdleContradiction& found : find_idle_contradictions(report.analysis())) {
    const Assignment& first = found.idle.front();
    if (!told.insert(first.variable).second) continue;
    const Assignment mode{report.plant()[found.mode.component].mode, automata::ValueId(found.mode.mode.index())};
    auto& finding = report.add(Code::impossible_command, declared(report, first.variable),
                               "while all controls are idle, " + report.list({mode}) + " contradicts the model: with " +
                                   report.list(found.idle) + " every guard holds there");
    finding.suggestion = "choose a default that every reachable mode permits";
    std::vector<Assignment> contradicted = found.idle;
    contradicted.push_back(mode);
    report.blame(finding, report.analysis().blame().of(contradicted, automata::constant(true)));
  }
}

/// Whether a formula asks a variable of the same domain, but not this one, for the value by itself or in a set.
bool asks(const automata::Plant& plant, const automata::Formula& formula, const Assignment& command) {
  if (formula.kind == automata::Formula::Kind::member && formula.variable != command.variable &&
      plant.variables[formula.variable].values == plant.variables[command.variable].values &&
      std::binary_search(formula.values.begin(), formula.values.end(), command.value)) {
    return true;
  }
  return std::any_of(formula.operands.begin(), formula.operands.end(),
                     [&](const automata::Formula& operand) { return asks(plant, operand, command); });
}

/// Whether the value means something where the domain is used elsewhere: then one domain serves several commands, and
/// this one does not need all of it.
bool is_read_elsewhere(const automata::Plant& plant, const Assignment& command) {
  return std::any_of(plant.components.begin(), plant.components.end(), [&](const automata::Component& component) {
    return std::any_of(component.modes.begin(), component.modes.end(),
                       [&](const automata::Mode& mode) { return asks(plant, mode.constraint, command); }) ||
           std::any_of(component.transitions.begin(), component.transitions.end(),
                       [&](const automata::Transition& t) { return asks(plant, t.guard, command); });
  });
}

/// Once for all that is not read of control variables that are declared in one place.
void report_unread(PlantReport& report, const std::vector<Assignment>& impossible) {
  std::map<std::pair<grammar::Span, bool>, std::vector<Assignment>> unread;
  for (const Assignment& command : find_unread_commands(report.analysis())) {
    if (std::find(impossible.begin(), impossible.end(), command) != impossible.end()) continue;
    unread[{declared(report, command.variable), is_read_elsewhere(report.plant(), command)}].push_back(command);
  }
  for (const auto& [key, commands] : unread) {
    const auto& [span, elsewhere] = key;
    auto& finding = report.add(Code::unread_command, span,
                               "nothing reads the " + std::string(commands.size() == 1 ? "command " : "commands ") +
                                   report.list(commands) + ": same effect as the idle value");
    if (elsewhere) finding.severity = grammar::Severity::note;
    finding.suggestion = "add a transition that reads it, or remove the value from the domain";
  }
}

/// Whether a guard reads an input that nothing drives, which is told already.
bool waits_for_undriven(const PlantReport& report, ComponentId component) {
  for (const automata::Transition& transition : report.plant()[component].transitions) {
    for (const VariableId v : variables_of(transition.guard)) {
      if (report.undriven().contains(v)) return true;
    }
  }
  return false;
}

void report_uncommanded(PlantReport& report) {
  std::map<std::string, std::vector<ComponentId>> by_type;
  for (const ComponentId component : find_uncommanded_components(report.analysis())) {
    if (waits_for_undriven(report, component)) continue;
    by_type[report.plant()[component].type].push_back(component);
  }
  for (const auto& [type, instances] : by_type) {
    const auto& places = report.declarations().instances;
    const auto place = places.find(report.plant()[instances.front()].name);
    std::vector<std::string> names;
    for (const ComponentId instance : instances) names.push_back(backquoted(report.plant()[instance].name));
    report.add(Code::uncommanded_component,
               place == places.end() ? report.at(report.plant()[instances.front()].origin) : place->second,
               "no command influences the guards of " + enumerated(names, 3));
  }
}

}  // namespace

void report_commands(PlantReport& report) {
  const std::vector<Assignment> impossible = find_impossible_commands(report.analysis());
  report_impossible_commands(report, impossible);
  report_contradicting_idle(report, impossible);
  report_unread(report, impossible);
  report_uncommanded(report);
}

}  // namespace rmpl::compiler
