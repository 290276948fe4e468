// Groups that are the same but for names share what tells of the plant alone: each goes its way as if it were alone.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "automata/instance.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/groups.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"

namespace rmpl::property {
namespace {

using automata::Modes;
using automata::Observation;

std::unique_ptr<runtime::Estimator> make(automata::PlantStep& step, const runtime::EstimatorOptions& options,
                                         bool exact) {
  return exact ? runtime::make_exact_estimator(step, options) : runtime::make_k_best_estimator(step, options);
}

/// The share of each mode combination of some components, one after the other from `first` on.
std::map<Modes, double> by_modes(const runtime::Belief& belief, std::size_t first, std::size_t size) {
  std::map<Modes, double> result;
  for (const runtime::BeliefEntry& entry : belief) {
    const auto begin = entry.state.modes.begin() + static_cast<std::ptrdiff_t>(first);
    result[Modes(begin, begin + static_cast<std::ptrdiff_t>(size))] += entry.probability;
  }
  return result;
}

RC_GTEST_PROP(LikeGroups, EachIsAsItIsAlone, ()) {
  const Model model = *models({.open = chance(50)});
  const std::size_t copies = up_to(2, 4);
  automata::Plant plant;
  std::vector<Log> logs_of;
  for (std::size_t i = 0; i < copies; ++i) {
    automata::instantiate(plant, "part" + std::to_string(i), model.plant);
    logs_of.push_back(*logs(model.plant, 6));
  }
  const runtime::Groups groups(plant);
  const bool exact = chance(30);
  const runtime::EstimatorOptions options{.k = up_to(1, 4), .live_clocks_only = chance(50)};
  RC_LOG() << copies << " copies, " << (exact ? "exact" : "k-best of ") << options.k
           << (options.live_clocks_only ? ", live clocks" : "") << std::endl;
  automata::PlantStep step(plant), own_step(model.plant);
  // A reading that has to do with no component is the first group's: another one than alone.
  for (const automata::VariableId v : model.plant.observables)
    RC_PRE(!own_step.locality().support_of(automata::is(v, automata::ValueId(0))).components.empty());
  const auto together = make(step, options, exact);
  const std::size_t size = model.plant.components.size(), variables = model.plant.variables.size();
  // What touches no component goes with the first group, which may be of a shape of its own.
  RC_ASSERT(groups.shapes().size() <= runtime::Groups(model.plant).size() + 1);
  RC_TAG(groups.shapes().size());

  std::vector<std::unique_ptr<runtime::Estimator>> alone;
  for (std::size_t i = 0; i < copies; ++i) alone.push_back(make(own_step, options, exact));
  const std::size_t apart = together->groups();
  for (std::size_t l = 0; l < logs_of.front().lines.size(); ++l) {
    const automata::Ticks now = logs_of.front().lines[l].time;
    automata::ControlAction action;
    Observation seen, set_aside;
    std::vector<Observation> own_seen(copies);
    Modes modes;
    for (std::size_t i = 0; i < copies; ++i) {
      const std::vector<LogLine>& lines = logs_of[i].lines;
      const LogLine& line = lines[std::min(l, lines.size() - 1)];
      action.insert(action.end(), line.action.begin(), line.action.end());
      const auto of_whole = [&](automata::Assignment reading) {
        return automata::Assignment{automata::VariableId(reading.variable.index() + i * variables), reading.value};
      };
      for (const automata::Assignment& reading : line.observation) seen.push_back(of_whole(reading));
      const runtime::Estimate& estimate = alone[i]->update(line.action, line.observation, now);
      modes.insert(modes.end(), estimate.modes.begin(), estimate.modes.end());
      for (const automata::Assignment& reading : estimate.set_aside) set_aside.push_back(of_whole(reading));
    }
    const runtime::Estimate& estimate = together->update(action, seen, now);
    // A command that contradicts one store enables every guard, in the other parts too.
    if (together->groups() != apart) return;
    RC_ASSERT(estimate.modes == modes);
    RC_ASSERT(estimate.set_aside == set_aside);
    for (std::size_t i = 0; i < copies; ++i) {
      std::vector<automata::ComponentId> components;
      for (std::size_t c = 0; c < size; ++c) components.emplace_back(i * size + c);
      const auto found = by_modes(together->belief_about(components), i * size, size);
      std::vector<automata::ComponentId> own;
      for (std::size_t c = 0; c < size; ++c) own.emplace_back(c);
      const auto expected = by_modes(alone[i]->belief_about(own), 0, size);
      RC_LOG() << "line " << l + 1 << " copy " << i << ": " << found.size() << " for " << expected.size() << std::endl;
      RC_ASSERT(found.size() == expected.size());
      for (const auto& [combination, share] : expected) {
        RC_ASSERT(found.contains(combination));
        RC_ASSERT(std::abs(found.at(combination) - share) <= 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace rmpl::property
