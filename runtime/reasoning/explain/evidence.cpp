// Evidence, by minimal conflicts of a store whose interconnections are assumptions.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/explain/evidence.hpp"

#include <algorithm>
#include <string>

namespace rmpl::runtime {
namespace {

using automata::Assignment;
using automata::Plant;
using automata::ValueId;
using automata::VariableId;

/// The first value of what may be told: left out.
constexpr std::size_t told = 1;

/// No name of a plant holds a space.
automata::Variables with_selectors(const Plant& plant) {
  automata::Variables variables = plant.variables;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    automata::Variable mode{"mode " + std::to_string(c), {"left out"}};
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m)
      mode.values.push_back("mode " + std::to_string(m));
    variables.add(std::move(mode));
  }
  for (std::size_t i = 0; i < plant.interconnections.size(); ++i) {
    variables.add({"interconnection " + std::to_string(i), {"left out", "told"}});
  }
  return variables;
}

Assignment mode_told(const Plant& plant, std::size_t component, std::size_t mode) {
  return {VariableId(plant.variables.size() + component), ValueId(told + mode)};
}

Assignment interconnection_told(const Plant& plant, std::size_t position) {
  return {VariableId(plant.variables.size() + plant.components.size() + position), ValueId(told)};
}

}  // namespace

Evidences::Evidences(const Plant& plant) : plant_(plant), theory_(with_selectors(plant)) {
  for (std::size_t i = 0; i < plant.interconnections.size(); ++i) {
    theory_.tell_if(interconnection_told(plant, i), plant.interconnections[i].constraint);
  }
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const automata::Component& component = plant.components[c];
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      theory_.tell_if(mode_told(plant, c, m), automata::is(component.mode, ValueId(m)));
      theory_.tell_if(mode_told(plant, c, m), component.modes[m].constraint);
    }
  }
}

std::vector<Assignment> Evidences::store(const automata::Modes& modes) const {
  std::vector<Assignment> result;
  for (std::size_t c = 0; c < modes.size(); ++c) result.push_back(mode_told(plant_, c, modes[c].index()));
  for (std::size_t i = 0; i < plant_.interconnections.size(); ++i) result.push_back(interconnection_told(plant_, i));
  return result;
}

bool Evidences::entails(const std::vector<Assignment>& store, Assignment reading) {
  return !theory_.allows_other(store, reading);
}

Evidence Evidences::of(automata::ComponentId component, const automata::Modes& estimate, const automata::Modes& story,
                       const automata::Observation& observation) {
  Evidence evidence{component, estimate[component.index()], story, Evidence::Kind::outweighed, {}, {}, {}, 0};
  std::vector<Assignment> all(observation.begin(), observation.end());
  const std::vector<Assignment> store = this->store(story);
  all.insert(all.end(), store.begin(), store.end());
  if (theory_.consistent(all)) {
    outweigh(evidence, estimate, observation);
    return evidence;
  }
  evidence.kind = Evidence::Kind::refuted;
  for (const Assignment& part : theory_.minimal_conflict(theory_.conflict())) {
    const std::size_t variable = part.variable.index();
    const std::size_t modes = plant_.variables.size();
    const std::size_t interconnections = modes + plant_.components.size();
    if (variable >= interconnections) {
      evidence.interconnections.push_back(variable - interconnections);
    } else if (variable >= modes) {
      evidence.modes.emplace_back(variable - modes);
    } else {
      evidence.readings.push_back(part);
    }
  }
  return evidence;
}

/// The readings that the estimate implies and the story leaves open: each made the story less likely by its 1/m.
void Evidences::outweigh(Evidence& evidence, const automata::Modes& estimate,
                         const automata::Observation& observation) {
  const std::vector<Assignment> with = store(estimate);
  const std::vector<Assignment> without = store(evidence.story);
  for (const Assignment& reading : observation) {
    if (entails(with, reading) && !entails(without, reading)) evidence.readings.push_back(reading);
  }
}

}  // namespace rmpl::runtime
