// Why a run cannot go on.
// SPDX-License-Identifier: MIT
#include "verifier/witness/conflict.hpp"

#include <algorithm>

#include "automata/assignment_text.hpp"
#include "automata/logic/theory.hpp"
#include "base/check.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::ComponentId;
using automata::Modes;
using automata::Plant;
using automata::ValueId;
using automata::VariableId;

namespace {

constexpr std::string_view off = "off";
constexpr std::string_view on = "on";

}  // namespace

Conflict conflict_of(const Plant& plant, const Modes& modes) {
  // Every constraint stands under a variable of its own, so that the solver can name it.
  automata::Variables variables = plant.variables;
  std::vector<Assignment> switches;
  const std::size_t constraints = plant.interconnections.size() + plant.components.size();
  for (std::size_t i = 0; i < constraints; ++i) {
    const VariableId own = variables.add({"constraint " + std::to_string(i), {std::string(off), std::string(on)}});
    switches.push_back({own, ValueId(std::size_t{1})});
  }
  automata::Theory theory(variables);
  for (std::size_t i = 0; i < plant.interconnections.size(); ++i) {
    theory.tell_if(switches[i], plant.interconnections[i].constraint);
  }
  for (std::size_t c = 0; c < modes.size(); ++c) {
    theory.tell_if(switches[plant.interconnections.size() + c], plant.components[c].modes[modes[c].index()].constraint);
  }
  std::vector<Assignment> assumptions = automata::assignments_of(plant, modes);
  assumptions.insert(assumptions.end(), switches.begin(), switches.end());
  const bool consistent = theory.consistent(assumptions);
  CHECK(!consistent && "the modes are impossible");

  Conflict result;
  for (const Assignment& a : theory.minimal_conflict(theory.conflict())) {
    const auto at = std::find(switches.begin(), switches.end(), a);
    if (at == switches.end()) continue;
    const auto position = static_cast<std::size_t>(at - switches.begin());
    if (position < plant.interconnections.size()) {
      result.interconnections.push_back(position);
    } else {
      result.constrained.emplace_back(position - plant.interconnections.size());
    }
  }
  std::sort(result.interconnections.begin(), result.interconnections.end());
  std::sort(result.constrained.begin(), result.constrained.end());
  // A mode takes part by its constraint, or by name.
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const bool by_name =
        std::any_of(result.interconnections.begin(), result.interconnections.end(), [&](std::size_t i) {
          const std::vector<VariableId> read = automata::variables_of(plant.interconnections[i].constraint);
          return std::find(read.begin(), read.end(), plant.components[c].mode) != read.end();
        });
    const bool constrained =
        std::find(result.constrained.begin(), result.constrained.end(), ComponentId(c)) != result.constrained.end();
    if (by_name || constrained) result.modes.push_back({plant.components[c].mode, ValueId(modes[c].index())});
  }
  return result;
}

std::string to_text(const Plant& plant, const Conflict& conflict, const Modes& modes) {
  std::string result;
  const auto add = [&](const std::string& part) { result += (result.empty() ? "" : ", ") + part; };
  for (const Assignment& a : conflict.modes) {
    std::string text = automata::to_text(plant.variables, a);
    const ComponentId component = *plant.component_of(a.variable);
    const auto& all = conflict.constrained;
    if (std::find(all.begin(), all.end(), component) != all.end()) {
      const automata::Mode& mode = plant[component].modes[modes[component.index()].index()];
      text += " {" + automata::to_text(mode.constraint, plant.variables) + "}" + in_brackets(mode.origin);
    }
    add(text);
  }
  for (const std::size_t i : conflict.interconnections) {
    const automata::Interconnection& q = plant.interconnections[i];
    add(automata::to_text(q.constraint, plant.variables) + in_brackets(q.origin));
  }
  return result;
}

std::string to_text(const Plant& plant, const Stop& stop) {
  if (stop.still) {
    return "timelock: these steps take no time, and no other step lets time pass; give a transition a duration, or "
           "check in cycles, with --time";
  }
  if (!stop.conflict) return "deadlock: time cannot pass, and no step is possible";
  return "deadlock: no next state is possible, because these contradict each other: " +
         to_text(plant, *stop.conflict, stop.refused);
}

}  // namespace rmpl::verifier
