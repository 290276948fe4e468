// The window of a plant against all of its trajectories.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "runtime/reasoning/estimate/window/plant_window.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/belief.hpp"
#include "tests/reference/set_aside.hpp"

namespace rmpl::property {
namespace {

using automata::SystemState;
using automata::Ticks;
using Trajectories = std::map<std::vector<SystemState>, double>;

void divide_by_sum(Trajectories& trajectories) {
  double sum = 0;
  for (const auto& [states, probability] : trajectories) sum += probability;
  for (auto& [states, probability] : trajectories) probability /= sum;
}

/// One update further, every state that may follow each trajectory.
Trajectories extended(const reference::Step& step, const Trajectories& all, const LogLine& line, Ticks before) {
  Trajectories predictions;
  for (const auto& [states, weight] : all) {
    const reference::Belief next = reference::predicted(step, {{states.back(), 1.0}}, line.action, before, line.time);
    for (const auto& [state, probability] : next) {
      std::vector<SystemState> longer = states;
      longer.push_back(state);
      predictions[longer] = weight * probability;
    }
  }
  const auto weighed = [&](const automata::Observation& readings) {
    Trajectories posterior;
    for (const auto& [longer, probability] : predictions) {
      const double worth = probability * step.observation_factor(longer.back().modes, readings);
      if (worth > 0) posterior[longer] = worth;
    }
    return posterior;
  };
  const auto counted =
      reference::set_aside(line.observation, [&](const automata::Observation& rest) { return !weighed(rest).empty(); });
  if (counted) return weighed(counted->rest);
  Trajectories standing;
  for (const auto& [states, weight] : all) {
    std::vector<SystemState> longer = states;
    longer.push_back(states.back());
    standing[longer] = weight;
  }
  return standing;
}

/// Over random logs; a group is searched where it has more than `ways` to go on.
void is_the_best_of_all(std::size_t ways) {
  const Model model = *models({.max_components = 2, .max_attributes = 4});
  const Log log = *logs(model.plant, 4);
  const std::size_t updates = up_to(1, 3);
  const std::size_t k = up_to(1, 5);
  const reference::Step slow(model.plant);
  runtime::PlantWindow window(model.plant, {.k = k}, true, updates, ways);
  std::vector<reference::Belief> beliefs{reference::initial_belief(slow)};
  double sum = 0;
  for (const auto& [state, probability] : beliefs[0]) sum += probability;
  for (auto& [state, probability] : beliefs[0]) probability /= sum;
  for (std::size_t i = 0; i < log.lines.size(); ++i) {
    const LogLine& line = log.lines[i];
    const Ticks before = i > 0 ? log.lines[i - 1].time : Ticks{};
    window.update(line.action, line.observation, line.time);
    const auto expected =
        reference::belief_update(slow, beliefs.back(), line.action, line.observation, before, line.time);
    if (!expected.follows) return;  // groups in which a state follows go on, which the twin does not know
    beliefs.push_back(expected.belief);
    const std::size_t first = i + 1 - std::min(updates, i + 1);
    Trajectories all;
    for (const auto& [state, probability] : beliefs[first]) all[{state}] = probability;
    for (std::size_t j = first; j <= i; ++j) {
      all = extended(slow, all, log.lines[j], j > 0 ? log.lines[j - 1].time : Ticks{});
    }
    divide_by_sum(all);
    std::vector<double> probabilities;
    for (const auto& [states, probability] : all) probabilities.push_back(probability);
    std::sort(probabilities.begin(), probabilities.end(), std::greater<>());
    const auto found = window.trajectories();
    RC_ASSERT(found.size() == std::min(k, all.size()));
    RC_ASSERT(window.searched() == (ways == 0));
    RC_ASSERT(!window.cut());
    // A group that is searched is normalised over its best: ratios are the same.
    for (std::size_t t = 0; t < found.size(); ++t) {
      RC_ASSERT(all.contains(found[t].states));
      const double scale = ways > 0 ? 1 : found.front().probability / probabilities.front();
      RC_ASSERT(std::abs(all.at(found[t].states) * scale - found[t].probability) < 1e-9);
      RC_ASSERT(std::abs(probabilities[t] * scale - found[t].probability) < 1e-9);
    }
  }
}

/// With few states kept, and readings that they often do not explain: what counted once counts as long as the window
/// reaches back to it, and every history explains it.
void keeps_what_it_explained(std::size_t ways) {
  const Model model = *models({.max_components = 2, .max_attributes = 4});
  const Log log = *logs(model.plant, 6);
  const std::size_t updates = up_to(1, 4);
  const reference::Step slow(model.plant);
  runtime::PlantWindow window(model.plant, {.k = up_to(1, 3)}, false, updates, ways);
  std::vector<std::size_t> left_out;
  for (std::size_t i = 0; i < log.lines.size(); ++i) {
    const LogLine& line = log.lines[i];
    window.update(line.action, line.observation, line.time);
    const auto found = window.trajectories();
    const auto set_aside = window.set_aside();
    const std::size_t first = i + 1 - set_aside.size();
    left_out.push_back(set_aside.back().size());
    for (std::size_t t = 0; t < set_aside.size(); ++t) {
      RC_ASSERT(left_out[first + t] > 0 || set_aside[t].empty());
      automata::Observation counted;
      for (const automata::Assignment& reading : log.lines[first + t].observation) {
        if (std::find(set_aside[t].begin(), set_aside[t].end(), reading) == set_aside[t].end())
          counted.push_back(reading);
      }
      for (const auto& trajectory : found) {
        RC_ASSERT(slow.observation_factor(trajectory.states[t + 1].modes, counted) > 0);
      }
    }
  }
}

RC_GTEST_PROP(PlantWindow, KeepsWhatItExplained, ()) { keeps_what_it_explained(runtime::PlantWindow::most_ways); }
RC_GTEST_PROP(PlantWindow, KeepsWhatItExplainedWhereItSearches, ()) { keeps_what_it_explained(0); }

RC_GTEST_PROP(PlantWindow, IsTheBestOfAllTrajectories, ()) { is_the_best_of_all(runtime::PlantWindow::most_ways); }
RC_GTEST_PROP(PlantWindow, IsSearchedToTheSameEnd, ()) { is_the_best_of_all(0); }

}  // namespace
}  // namespace rmpl::property
