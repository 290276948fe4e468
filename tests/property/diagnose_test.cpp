// Diagnoses of snapshots against every assignment of modes.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/diagnose.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/diagnoses.hpp"

namespace rmpl::property {
namespace {

using Faults = std::vector<std::pair<automata::ComponentId, automata::ModeId>>;

/// Of any attributes; every third plant begins in a fault now and then.
struct Snapshot {
  Model model;
  automata::Observation observation;
};

Snapshot snapshot() {
  Snapshot made{*models(), {}};
  for (automata::Component& component : made.model.plant.components) {
    if (!chance(33)) continue;
    double sum = 0;
    for (double& initial : component.initial) sum += initial = static_cast<double>(up_to(0, 4));
    for (double& initial : component.initial) initial = sum > 0 ? initial / sum : 0.0;
    if (sum == 0) component.initial.front() = 1;
  }
  for (const automata::Assignment& reading : *partial_assignments(made.model.plant.variables)) {
    if (!made.model.plant.component_of(reading.variable)) made.observation.push_back(reading);
  }
  std::sort(made.observation.begin(), made.observation.end());
  return made;
}

RC_GTEST_PROP(Diagnose, LeadingOnesAreTheMostProbable, ()) {
  const Snapshot given = snapshot();
  std::map<Faults, double> expected;
  double best = 0;
  for (const reference::Diagnosis& d : reference::diagnoses(given.model.plant, given.observation)) {
    if (d.probability > 0) expected.emplace(d.faults, d.probability);
    best = std::max(best, d.probability);
  }
  const std::size_t k = up_to(1, 8);
  const double ratio = std::pow(10.0, static_cast<double>(up_to(0, 40)) / 10);
  const auto found = runtime::diagnose(given.model.plant, given.observation, {.k = k, .ratio = ratio}).diagnoses;

  std::vector<double> probabilities;
  for (const auto& [faults, probability] : expected) probabilities.push_back(probability);
  std::sort(probabilities.rbegin(), probabilities.rend());
  const auto count_from = [&](double least) {
    return static_cast<std::size_t>(
        std::count_if(probabilities.begin(), probabilities.end(), [&](double p) { return p >= least; }));
  };
  // What is within a hair of the bound may fall on either side of it.
  RC_ASSERT(found.size() >= std::min(k, count_from(best / ratio * (1 + 1e-6))));
  RC_ASSERT(found.size() <= std::min(k, count_from(best / ratio * (1 - 1e-6))));
  std::map<Faults, double> distinct;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto known = expected.find(found[i].faults);
    RC_ASSERT(known != expected.end());
    RC_ASSERT(std::abs(found[i].probability - known->second) < 1e-12);
    RC_ASSERT(std::abs(std::exp(found[i].log_probability) - known->second) < 1e-12);
    RC_ASSERT(std::abs(found[i].probability - probabilities[i]) < 1e-9 * probabilities[i]);
    RC_ASSERT(distinct.emplace(*known).second);
  }
}

RC_GTEST_PROP(Diagnose, AllMinimalAreThoseOfFewestFaults, ()) {
  const Snapshot given = snapshot();
  std::map<Faults, double> expected;
  std::size_t fewest = ~std::size_t{0};
  const auto all = reference::diagnoses(given.model.plant, given.observation);
  for (const reference::Diagnosis& d : all) fewest = std::min(fewest, d.faults.size());
  for (const reference::Diagnosis& d : all) {
    if (d.faults.size() == fewest) expected.emplace(d.faults, d.probability);
  }
  const auto found = runtime::diagnose(given.model.plant, given.observation, {.all_minimal = true});
  RC_ASSERT(found.count == expected.size());
  RC_ASSERT(found.diagnoses.size() == expected.size());
  if (!expected.empty()) RC_ASSERT(found.cardinality == fewest);
  for (std::size_t i = 0; i < found.diagnoses.size(); ++i) {
    const auto known = expected.find(found.diagnoses[i].faults);
    RC_ASSERT(known != expected.end());
    RC_ASSERT(std::abs(found.diagnoses[i].probability - known->second) < 1e-12);
    if (i > 0) {
      RC_ASSERT(found.diagnoses[i].faults != found.diagnoses[i - 1].faults);
      RC_ASSERT(found.diagnoses[i - 1].probability >= found.diagnoses[i].probability * (1 - 1e-9));
    }
  }
}

/// One of the fewest is one of those that the complete list has.
RC_GTEST_PROP(Diagnose, FirstIsOneOfTheMinimal, ()) {
  const Snapshot given = snapshot();
  const auto all = runtime::diagnose(given.model.plant, given.observation, {.all_minimal = true});
  const auto first = runtime::diagnose(given.model.plant, given.observation, {.all_minimal = true, .first = true});
  RC_ASSERT(first.cardinality == all.cardinality);
  RC_ASSERT(first.diagnoses.size() == std::min<std::size_t>(1, all.diagnoses.size()));
  if (first.diagnoses.empty()) return;
  RC_ASSERT(std::any_of(all.diagnoses.begin(), all.diagnoses.end(),
                        [&](const runtime::Diagnosis& d) { return d.faults == first.diagnoses.front().faults; }));
}

}  // namespace
}  // namespace rmpl::property
