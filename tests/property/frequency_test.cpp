// Estimates against the frequencies of simulated flights, of which nothing is read: one process.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <vector>

#include "base/error.hpp"
#include "runtime/executive/plant/simulated_plant.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"

namespace rmpl::property {
namespace {

using automata::Modes;
using automata::Ticks;

/// Flights of one plant; more where the environment says so.
std::uint64_t flights() {
  const char* const told = std::getenv("RMPL_FLIGHTS");
  return told == nullptr ? 400 : std::strtoull(told, nullptr, 10);
}

struct Step {
  automata::ControlAction action;
  Ticks now;
};

/// How often flights are in which modes after the steps; those that get stuck are no flights.
std::map<Modes, double> frequencies(const automata::Plant& plant, const std::vector<Step>& steps, double& total) {
  std::map<Modes, double> result;
  automata::PlantStep rules(plant);
  const automata::Scenario scenario;
  for (std::uint64_t seed = 1; seed <= flights(); ++seed) {
    try {
      runtime::SimulatedPlant flown(rules, scenario, seed);
      Ticks before;
      for (const Step& step : steps) {
        flown.issue(step.action, before);
        flown.sense(step.now);
        before = step.now;
      }
      ++result[*flown.truth()];
      ++total;
    } catch (const base::InputError&) {
      continue;
    }
  }
  return result;
}

/// By Pearson's statistic, with rare modes taken together; a chance of less than 1e-9 to fail by itself.
void compare(const std::map<Modes, double>& expected, const std::map<Modes, double>& seen, double total) {
  constexpr double least = 8;
  double statistic = 0, rare = 0, rarely = 0;
  std::size_t classes = 0;
  const auto add = [&](double probability, double count) {
    const double mean = probability * total;
    statistic += (count - mean) * (count - mean) / mean;
    ++classes;
  };
  for (const auto& [modes, count] : seen) RC_ASSERT(expected.contains(modes));
  for (const auto& [modes, probability] : expected) {
    const auto found = seen.find(modes);
    const double count = found == seen.end() ? 0 : found->second;
    if (probability * total < least) {
      rare += probability;
      rarely += count;
    } else {
      add(probability, count);
    }
  }
  if (rare * total >= least) add(rare, rarely);
  if (classes < 2) return;
  const auto freedom = static_cast<double>(classes - 1);
  // Wilson and Hilferty: the cube root is nearly normal.
  const double z = (std::cbrt(statistic / freedom) - (1 - 2 / (9 * freedom))) / std::sqrt(2 / (9 * freedom));
  RC_ASSERT(z < 6);
}

RC_GTEST_PROP(Frequencies, AreWhatIsEstimated, ()) {
  const Model model = *models({.max_components = 3, .max_attributes = 4, .tangled = true});
  const Log log = *logs(model.plant, 4);
  const bool exactly = chance(50);
  automata::PlantStep step(model.plant);
  const auto estimator = exactly ? runtime::make_exact_estimator(step, {.live_clocks_only = true})
                                 : runtime::make_k_best_estimator(step, {.k = 4096, .live_clocks_only = true});
  if (!estimator->estimate().consistent) return;
  std::vector<Step> steps;
  for (const LogLine& line : log.lines) {
    steps.push_back({line.action, line.time});
    if (!estimator->update(line.action, {}, line.time).follows) return;
  }
  std::map<Modes, double> expected;
  for (const runtime::BeliefEntry& entry : estimator->belief()) expected[entry.state.modes] += entry.probability;
  double total = 0;
  const std::map<Modes, double> seen = frequencies(model.plant, steps, total);
  if (total > 0) compare(expected, seen, total);
}

}  // namespace
}  // namespace rmpl::property
