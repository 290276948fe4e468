// Every assignment of modes, asked for its worlds.
// SPDX-License-Identifier: MIT
#include "tests/reference/diagnoses.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/reference/models.hpp"

namespace rmpl::reference {
namespace {

using automata::Component;
using automata::ModeId;
using automata::Transition;
using automata::Weight;

/// The likeliest way from a nominal mode, all ways tried out that pass no fault twice.
double entering(const Component& component, ModeId fault, const std::set<ModeId>& behind = {}) {
  if (!component.modes[fault.index()].fault) return 1;
  std::set<ModeId> passed = behind;
  if (!passed.insert(fault).second) return 0;
  double most = 0;
  for (const Transition& t : component.transitions) {
    if (t.to != fault) continue;
    const double p = t.weight.kind == Weight::Kind::rate ? 1 - std::exp(-t.weight.value) : t.weight.value;
    most = std::max(most, p * entering(component, t.from, passed));
  }
  return most;
}

/// Per mode the prior of being in it; for a nominal one that of being in any of them.
std::vector<double> priors(const Component& component) {
  double faulty_at_first = 0;
  bool any_nominal = false;
  for (std::size_t m = 0; m < component.modes.size(); ++m) {
    any_nominal = any_nominal || !component.modes[m].fault;
    if (component.modes[m].fault) faulty_at_first += component.initial[m];
  }
  std::vector<double> prior(component.modes.size(), 0.0);
  double faulty = 0;
  for (std::size_t m = 0; m < component.modes.size(); ++m) {
    if (!component.modes[m].fault) continue;
    prior[m] = component.initial[m] + (1 - faulty_at_first) * entering(component, ModeId(m));
    faulty += prior[m];
  }
  const double nominal = any_nominal ? std::max(0.0, 1 - faulty) : 0.0;
  for (std::size_t m = 0; m < component.modes.size(); ++m) {
    if (!component.modes[m].fault) prior[m] = nominal;
    if (nominal + faulty > 0) prior[m] /= nominal + faulty;
  }
  return prior;
}

}  // namespace

std::vector<Diagnosis> diagnoses(const automata::Plant& plant, const automata::Observation& observation) {
  const Models models(plant);
  std::vector<std::size_t> sizes;
  std::vector<std::vector<double>> prior;
  for (const Component& component : plant.components) {
    sizes.push_back(component.modes.size());
    prior.push_back(priors(component));
  }
  std::map<std::vector<std::pair<automata::ComponentId, ModeId>>, double> found;
  for (const std::vector<std::size_t>& tuple : tuples(sizes)) {
    Diagnosis diagnosis{{}, 1};
    std::vector<automata::Assignment> assumptions = observation;
    for (std::size_t c = 0; c < tuple.size(); ++c) {
      const Component& component = plant.components[c];
      assumptions.push_back({component.mode, automata::ValueId(tuple[c])});
      diagnosis.probability *= prior[c][tuple[c]];
      if (component.modes[tuple[c]].fault) diagnosis.faults.emplace_back(c, ModeId(tuple[c]));
    }
    if (models.consistent(assumptions)) found[diagnosis.faults] = diagnosis.probability;
  }
  std::vector<Diagnosis> all;
  for (const auto& [faults, probability] : found) all.push_back({faults, probability});
  std::stable_sort(all.begin(), all.end(),
                   [](const Diagnosis& a, const Diagnosis& b) { return a.probability > b.probability; });
  return all;
}

}  // namespace rmpl::reference
