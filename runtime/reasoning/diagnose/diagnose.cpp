// Diagnosis of one snapshot: the leading fault assignments by conflict-directed search, those with the fewest faults by
// counting.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/diagnose.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <span>

#include "runtime/reasoning/diagnose/minimal.hpp"
#include "runtime/reasoning/diagnose/snapshot.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {
namespace {

std::vector<Statuses> all_statuses(const automata::Plant& plant) {
  std::vector<Statuses> all;
  for (const automata::Component& component : plant.components) all.push_back(statuses_of(component));
  return all;
}

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
    const double prior = components[c].priors[candidate[c]];
    diagnosis.probability *= prior;
    diagnosis.log_probability += std::log(prior);
    if (candidate[c] > 0) diagnosis.faults.emplace_back(c, components[c].faults[candidate[c] - 1]);
  }
  return diagnosis;
}

/// Most probable first, in the order of the search: among equal priors component by component, nominal before faults.
/// Compared is by how much each fault is less likely than being nominal, in whole units, so that equal products are
/// equal in whatever order they are multiplied.
class ByPrior {
 public:
  explicit ByPrior(const std::vector<Statuses>& components) {
    for (const Statuses& statuses : components) {
      auto& units = units_.emplace_back();
      for (std::size_t f = 0; f < statuses.faults.size(); ++f) {
        const double odds = std::log(statuses.priors[f + 1]) - std::max(-limit, std::log(statuses.priors[0]));
        units[statuses.faults[f]] = std::llround(std::ldexp(std::max(-limit, odds), 40));
      }
    }
  }

  void sort(std::vector<Diagnosis>& diagnoses) const {
    std::sort(diagnoses.begin(), diagnoses.end(), [this](const Diagnosis& a, const Diagnosis& b) {
      const std::int64_t of_a = units(a);
      const std::int64_t of_b = units(b);
      return of_a != of_b ? of_a > of_b : before(a, b);
    });
  }

 private:
  static constexpr double limit = 1000;  // of a logarithm that may be infinite

  [[nodiscard]] std::int64_t units(const Diagnosis& diagnosis) const {
    std::int64_t sum = 0;
    for (const auto& [component, mode] : diagnosis.faults) sum += units_[component.index()].at(mode);
    return sum;
  }
  static bool before(const Diagnosis& a, const Diagnosis& b) {
    const auto [in_a, in_b] = std::mismatch(a.faults.begin(), a.faults.end(), b.faults.begin(), b.faults.end());
    if (in_a == a.faults.end() || in_b == b.faults.end()) return in_a == a.faults.end() && in_b != b.faults.end();
    return in_a->first != in_b->first ? in_a->first > in_b->first : in_a->second < in_b->second;
  }

  std::vector<std::map<automata::ModeId, std::int64_t>> units_;  ///< per component
};

void leading(const automata::Plant& plant, const automata::Observation& observation, const DiagnoseOptions& options,
             Diagnoses& result) {
  Snapshot snapshot(plant, observation);
  OptimalSearch search(costs(snapshot.statuses()));
  const auto check = [&](std::span<const std::uint32_t> candidate) { return snapshot.refute(candidate); };
  constexpr double tolerance = 1e-9;
  double limit = std::numeric_limits<double>::infinity();
  // One candidate at a time: none is checked that would be too unlikely.
  while (result.diagnoses.size() < options.k && search.bound() <= limit) {
    const bool spent = result.checked >= options.candidates;
    search.set_budget(spent ? 0 : 1);
    const OptimalSearch::Outcome outcome = search.next(check);
    result.checked = search.checked();
    result.cut = spent && outcome == OptimalSearch::Outcome::budget;
    if (outcome == OptimalSearch::Outcome::exhausted || result.cut) break;
    if (outcome == OptimalSearch::Outcome::budget) continue;
    // The tolerance is for rounding: what is exactly so many times less likely still counts.
    if (result.diagnoses.empty()) limit = search.cost() + std::log(options.ratio) + tolerance;
    if (search.cost() > limit) break;
    Diagnosis found = diagnosis_of(search.values(), snapshot.statuses());
    const std::size_t faults = found.faults.size();
    result.cardinality = std::min(result.cardinality.value_or(faults), faults);
    result.diagnoses.push_back(std::move(found));
  }
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
        if (options.first) return;
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
bool fewest_of_circuit(const automata::Plant& plant, const std::vector<Statuses>& statuses,
                       const automata::Observation& observation, CircuitDiagnosis::Scope scope, Diagnoses& result) {
  const auto circuit = circuit_of(plant);
  if (!circuit) return false;
  const auto report = [&](const FaultSet& faults) {
    std::vector<std::uint32_t> candidate(statuses.size(), 0);
    for (const automata::ComponentId component : faults) candidate[component.index()] = 1;
    result.diagnoses.push_back(diagnosis_of(candidate, statuses));
  };
  const auto minimal = CircuitDiagnosis(*circuit).solve(observation, scope, report);
  if (!minimal) return false;
  result.cardinality = minimal->cardinality;
  result.count = minimal->count;
  result.checked = minimal->checked;
  return true;
}

/// Whether every component is as likely to fail as any other, and likelier not to: then fewer faults are likelier.
bool equally_reliable(const std::vector<Statuses>& statuses) {
  const auto alike = [&](const Statuses& s) {
    return s.priors.size() == 2 && s.priors == statuses.front().priors && s.priors[0] > s.priors[1] && s.priors[1] > 0;
  };
  return std::all_of(statuses.begin(), statuses.end(), alike);
}

}  // namespace

Diagnoses diagnose(const automata::Plant& plant, const automata::Observation& observation,
                   const DiagnoseOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Diagnoses result;
  const std::vector<Statuses> statuses = all_statuses(plant);
  using Scope = CircuitDiagnosis::Scope;
  if (!options.all_minimal) {
    const bool fewest_will_do = options.k == 1 && equally_reliable(statuses) &&
                                fewest_of_circuit(plant, statuses, observation, Scope::first, result);
    if (!fewest_will_do) leading(plant, observation, options, result);
    result.count = result.diagnoses.size();
  } else {
    const Scope scope = options.first ? Scope::first : options.count_only ? Scope::count : Scope::list;
    if (!fewest_of_circuit(plant, statuses, observation, scope, result)) {
      fewest(plant, observation, options, result);
      result.count = result.diagnoses.size();
      if (options.count_only) result.diagnoses.clear();
    }
    ByPrior(statuses).sort(result.diagnoses);
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace rmpl::runtime
