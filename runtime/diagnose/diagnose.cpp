// Diagnosis of one snapshot: the leading fault assignments by conflict-directed search, those with the fewest faults by
// counting.
// SPDX-License-Identifier: MIT
#include "runtime/diagnose/diagnose.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <span>

#include "runtime/diagnose/minimal.hpp"
#include "runtime/diagnose/snapshot.hpp"
#include "runtime/ocsp/ocsp.hpp"
#include "runtime/estimate/order.hpp"

namespace runtime {
namespace {

/// Costs whose order is that of falling priors.
OptimalSearch::Costs costs(const std::vector<Statuses>& components) {
  OptimalSearch::Costs costs;
  for (const Statuses& statuses : components) {
    auto& values = costs.emplace_back();
    // Rounding may leave a prior of more than 1.
    for (const double prior : statuses.priors) values.push_back(std::max(0.0, -std::log(prior)));
  }
  return costs;
}

Diagnosis diagnosis_of(std::span<const std::uint32_t> candidate, const std::vector<Statuses>& components) {
  Diagnosis diagnosis;
  diagnosis.probability = 1;
  for (std::size_t c = 0; c < candidate.size(); ++c) {
    diagnosis.probability *= components[c].priors[candidate[c]];
    if (candidate[c] > 0) diagnosis.faults.emplace_back(c, components[c].faults[candidate[c] - 1]);
  }
  return diagnosis;
}

/// The order of the search among equal priors: component by component, nominal before faults.
bool before(const Diagnosis& a, const Diagnosis& b) {
  const auto [in_a, in_b] = std::mismatch(a.faults.begin(), a.faults.end(), b.faults.begin(), b.faults.end());
  if (in_a == a.faults.end() || in_b == b.faults.end()) return in_a == a.faults.end() && in_b != b.faults.end();
  return in_a->first != in_b->first ? in_a->first > in_b->first : in_a->second < in_b->second;
}

void leading(const automata::Plant& plant, const automata::Observation& observation, const DiagnoseOptions& options,
             Diagnoses& result) {
  Snapshot snapshot(plant, observation);
  OptimalSearch search(costs(snapshot.statuses()));
  search.set_budget(options.candidates);
  const auto check = [&](std::span<const std::uint32_t> candidate) { return snapshot.refute(candidate); };
  while (result.diagnoses.size() < options.k) {
    const OptimalSearch::Outcome outcome = search.next(check);
    result.cut = outcome == OptimalSearch::Outcome::budget;
    if (outcome != OptimalSearch::Outcome::solution) break;
    result.diagnoses.push_back(diagnosis_of(search.values(), snapshot.statuses()));
    const std::size_t faults = result.diagnoses.back().faults.size();
    result.cardinality = std::min(result.cardinality.value_or(faults), faults);
  }
  result.checked = search.checked();
}

/// Raises the number of faults until some candidate has no more, then asks for one after the other, each excluded when
/// found: as none has fewer faults, that excludes no other. The store grows with the faults that it counts, so it
/// counts few to begin with. A question that is answered by "none" counts as a candidate checked.
void fewest(const automata::Plant& plant, const automata::Observation& observation, const DiagnoseOptions& options,
            Diagnoses& result) {
  constexpr std::size_t counted_first = 4;
  std::size_t faults = 0;
  for (std::size_t counted = counted_first;; counted *= 4) {
    Snapshot snapshot(plant, observation, counted);
    if (!snapshot.explicable()) return;
    while (faults < counted) {
      result.cut = result.checked == options.candidates;
      if (result.cut) return;
      ++result.checked;
      if (const auto candidate = snapshot.at_most(faults)) {
        result.cardinality = faults;
        result.diagnoses.push_back(diagnosis_of(*candidate, snapshot.statuses()));
        snapshot.exclude(*candidate);
      } else if (result.cardinality) {
        return;
      } else {
        ++faults;
      }
    }
  }
}

/// The same for a circuit, by cores and sections; false where the plant is none, or an input is not observed.
bool fewest_of_circuit(const automata::Plant& plant, const automata::Observation& observation,
                       const DiagnoseOptions& options, Diagnoses& result) {
  const auto circuit = circuit_of(plant);
  if (!circuit) return false;
  std::vector<Statuses> statuses;
  for (const automata::Component& component : plant.components) statuses.push_back(statuses_of(component));
  const auto report = [&](const FaultSet& faults) {
    std::vector<std::uint32_t> candidate(statuses.size(), 0);
    for (const automata::ComponentId component : faults) candidate[component.index()] = 1;
    result.diagnoses.push_back(diagnosis_of(candidate, statuses));
  };
  const auto scope = options.count_only ? CircuitDiagnosis::Scope::count : CircuitDiagnosis::Scope::list;
  const auto minimal = CircuitDiagnosis(*circuit).solve(observation, scope, report);
  if (!minimal) return false;
  result.cardinality = minimal->cardinality;
  result.count = minimal->count;
  result.checked = minimal->checked;
  return true;
}

}  // namespace

Diagnoses diagnose(const automata::Plant& plant, const automata::Observation& observation,
                   const DiagnoseOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Diagnoses result;
  if (!options.all_minimal || !fewest_of_circuit(plant, observation, options, result)) {
    (options.all_minimal ? fewest : leading)(plant, observation, options, result);
    result.count = result.diagnoses.size();
    if (options.count_only) result.diagnoses.clear();
  }
  put_in_order(result.diagnoses, before);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace runtime
