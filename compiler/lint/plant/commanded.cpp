// Finding: components that wait for something on which no command has any influence.
//
// Independence is a matter of who reads whom: a guard depends on the modes and controls of its support (store/support),
// and on nothing else. So what is found is proved; what is not found may still never be moved by a command.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "automata/step/transition_rules.hpp"
#include "compiler/lint/plant/findings.hpp"

namespace rmpl::compiler {

using automata::ComponentId;
using automata::Plant;
using automata::Support;

namespace {

/// What the guards of the nominal transitions of a component depend on; nothing where none has a guard.
std::optional<Support> awaited(const PlantAnalysis& analysis, std::size_t c) {
  std::optional<Support> result;
  const automata::Component& component = analysis.plant().components[c];
  for (const automata::Transition& t : component.transitions) {
    const bool stays = t.from == t.to && !t.restart;
    if (component.is_fault(t) || t.guard.is_true() || stays || !can_ever_be_taken(t)) continue;
    if (!analysis.reach().reached[c][t.from.index()]) continue;
    if (!result) result.emplace();
    result->join(analysis.locality().support_of(t.guard));
  }
  return result;
}

}  // namespace

std::vector<ComponentId> find_uncommanded_components(const PlantAnalysis& analysis) {
  const Plant& plant = analysis.plant();
  if (plant.controls.empty()) return {};
  std::vector<std::optional<Support>> supports;
  std::vector<std::vector<std::size_t>> readers(plant.components.size());
  std::vector<bool> commanded(plant.components.size());
  std::vector<std::size_t> open;
  const auto command = [&](std::size_t c) {
    if (!commanded[c]) open.push_back(c);
    commanded[c] = true;
  };
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    supports.push_back(awaited(analysis, c));
    if (!supports[c]) continue;
    for (const ComponentId read : supports[c]->components) readers[read.index()].push_back(c);
    if (!supports[c]->controls.empty()) command(c);
  }
  while (!open.empty()) {
    const std::size_t from = open.back();
    open.pop_back();
    for (const std::size_t reader : readers[from]) command(reader);
  }
  std::vector<ComponentId> found;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    if (supports[c] && !commanded[c]) found.emplace_back(c);
  }
  return found;
}

}  // namespace rmpl::compiler
