// The estimators against the sums of Fig. 6-10 and the maxima of Fig. 6-11.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "automata/clock_use.hpp"
#include "base/bounded_cache.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/open_readings.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/belief.hpp"
#include "tests/reference/set_aside.hpp"
#include "tests/unit/runtime/reasoning/estimate/estimate_models.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;

constexpr std::size_t everything = 1u << 20;  // a k that keeps all states

void same_belief(const runtime::Belief& found, const reference::Belief& expected) {
  RC_ASSERT(found.size() == expected.size());
  for (const runtime::BeliefEntry& entry : found) {
    const auto known = expected.find(entry.state);
    RC_ASSERT(known != expected.end());
    RC_ASSERT(std::abs(entry.probability - known->second) < 1e-9);
  }
  for (std::size_t i = 1; i < found.size(); ++i)
    RC_ASSERT(found[i - 1].probability >= found[i].probability * (1 - 1e-9));
}

/// To the last bit.
bool same(const runtime::Belief& a, const runtime::Belief& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const runtime::BeliefEntry& one, const runtime::BeliefEntry& other) {
                      return one.state == other.state && one.probability == other.probability;
                    });
}

void same_mode(const runtime::Estimate& found, const reference::Belief& belief) {
  const reference::MostLikely expected = reference::most_likely(belief);
  RC_ASSERT(std::abs(found.probability - expected.probability) < 1e-9);
  if (expected.unique) RC_ASSERT(found.modes == expected.modes);
}

/// Runs an estimator that is to be exact beside the twin.
void compare_with_exact(runtime::Estimator& fast, const Model& model, const Log& log) {
  const reference::Step slow(model.plant);
  reference::Belief belief = reference::initial_belief(slow);
  Ticks before;
  for (const LogLine& line : log.lines) {
    const reference::Update expected =
        reference::belief_update(slow, belief, line.action, line.observation, before, line.time);
    const runtime::Estimate& estimate = fast.update(line.action, line.observation, line.time);
    RC_ASSERT(estimate.follows == expected.follows);
    if (!expected.follows) return;  // groups in which a state follows go on, which the twin does not know
    RC_ASSERT(estimate.set_aside == expected.set_aside);
    RC_ASSERT(estimate.consistent == expected.set_aside.empty());
    same_belief(fast.belief(), expected.belief);
    same_mode(estimate, expected.belief);
    belief = expected.belief;
    before = line.time;
  }
}

RC_GTEST_PROP(Estimate, ExactIsFigure6_10, ()) {
  const Model model = *models();
  const Log log = *logs(model.plant, 5);
  automata::PlantStep step(model.plant);
  const auto estimator = runtime::make_exact_estimator(step, {});
  compare_with_exact(*estimator, model, log);
}

RC_GTEST_PROP(Estimate, KBestThatKeepsAllIsExact, ()) {
  const Model model = *models();
  const Log log = *logs(model.plant, 4);
  automata::PlantStep step(model.plant);
  const auto estimator = runtime::make_k_best_estimator(step, {.k = everything, .clocks = everything});
  compare_with_exact(*estimator, model, log);
}

/// A belief without the clock starts that nothing reads.
reference::Belief without_dead_clocks(const automata::Plant& plant, const reference::Belief& belief) {
  reference::Belief result;
  for (const auto& [state, probability] : belief) {
    automata::SystemState kept = state;
    for (std::size_t c = 0; c < kept.modes.size(); ++c) {
      if (!automata::needs_clock(plant.components[c], kept.modes[c])) kept.clock_starts[c] = {};
    }
    result[kept] += probability;
  }
  return result;
}

/// The belief of each mode combination as a whole.
std::map<automata::Modes, double> by_modes(const reference::Belief& belief) {
  std::map<automata::Modes, double> result;
  for (const auto& [state, probability] : belief) result[state.modes] += probability;
  return result;
}

/// The k most probable mode combinations of the posterior that follows from the belief kept before, with all their
/// clocks, however long nothing changes.
RC_GTEST_PROP(Estimate, KBestKeepsTheBest, ()) {
  const Model model = *models({.max_attributes = 6, .open = chance(60)});
  const Log log = chance(50) ? *logs(model.plant, 5) : *resting_logs(model.plant, 3, 12);
  const std::size_t k = up_to(1, 6);
  const bool live = chance(50);
  automata::PlantStep step(model.plant);
  const auto estimator = runtime::make_k_best_estimator(step, {.k = k,
                                                               .clocks = everything,
                                                               .patience = chance(50) ? up_to(0, 2) : 32,
                                                               .factored = false,
                                                               .normalise = false,
                                                               .live_clocks_only = live});
  const reference::Step slow(model.plant);
  Ticks before;
  for (const LogLine& line : log.lines) {
    reference::Belief kept;
    for (const runtime::BeliefEntry& entry : estimator->belief()) kept[entry.state] = entry.probability;
    reference::Belief prior = reference::predicted(slow, kept, line.action, before, line.time);
    if (live) prior = without_dead_clocks(model.plant, prior);
    reference::Belief posterior;
    for (const auto& [state, probability] : prior) {
      const double weighted = probability * slow.observation_factor(state.modes, line.observation);
      if (weighted > 0) posterior[state] = weighted;
    }
    const runtime::Estimate& estimate = estimator->update(line.action, line.observation, line.time);
    before = line.time;
    if (posterior.empty()) return;  // the widened searches that follow are no longer the k best of anything
    RC_ASSERT(estimate.consistent);
    std::vector<double> sums;
    const std::map<automata::Modes, double> sum_of = by_modes(posterior);
    for (const auto& [modes, sum] : sum_of) sums.push_back(sum);
    std::sort(sums.begin(), sums.end(), std::greater<>());
    if (sums.size() > k && sums[k] > sums[k - 1] * (1 - 1e-9)) return;  // a tie at the edge
    const double least = sums[std::min(k, sums.size()) - 1] * (1 - 1e-12);
    reference::Belief expected;
    double lost = 0;
    for (const auto& [state, probability] : posterior) {
      if (sum_of.at(state.modes) >= least) {
        expected[state] = probability;
      } else {
        lost += probability;
      }
    }
    if (sums.front() < 1e-200) {  // scaled up before it vanishes
      for (auto& [state, probability] : expected) probability /= sums.front();
    }
    same_belief(estimator->belief(), expected);
    RC_ASSERT(estimate.missing_mass >= lost - 1e-9);
  }
}

/// What is said to leave a reading open does so, whatever the other components do.
RC_GTEST_PROP(Estimate, OpenReadingsAreOpen, ()) {
  const Model model = *models({.max_attributes = 6, .open = true});
  automata::PlantStep step(model.plant);
  runtime::OpenReadings open(step);
  const reference::Step slow(model.plant);
  std::vector<std::size_t> sizes;
  for (const automata::Component& component : model.plant.components) sizes.push_back(component.modes.size());
  for (int i = 0; i < 4; ++i) {
    const automata::Modes modes = *modes_of(model.plant);
    for (const automata::VariableId seen : model.plant.observables) {
      const auto values = model.plant.variables[seen].values.size();
      const automata::Assignment reading{seen, automata::ValueId(up_to(0, values - 1))};
      if (!open.may_be_implied(reading)) {
        for (const auto& tuple : reference::tuples(sizes)) {
          const automata::Modes any(tuple.begin(), tuple.end());
          if (slow.possible(any)) RC_ASSERT(slow.observation_factor(any, {reading}) < 1);
        }
      }
      const runtime::Opening* opening = open.openings().of(reading);
      RC_TAG(opening == nullptr ? "opened by nobody alone" : "opened by one alone");
      for (const auto& tuple : reference::tuples(sizes)) {
        const automata::Modes any(tuple.begin(), tuple.end());
        const bool opened = opening != nullptr && opening->modes[any[opening->component.index()].index()];
        if (opened && slow.possible(any)) RC_ASSERT(slow.observation_factor(any, {reading}) < 1);
      }
      const auto* components = open.components(modes, reading);
      RC_TAG(components == nullptr ? "not known to be open" : "open");
      if (components == nullptr) continue;
      for (const auto& tuple : reference::tuples(sizes)) {
        const automata::Modes other(tuple.begin(), tuple.end());
        const bool alike = std::all_of(components->begin(), components->end(),
                                       [&](automata::ComponentId c) { return other[c.index()] == modes[c.index()]; });
        if (alike && slow.possible(other)) RC_ASSERT(slow.observation_factor(other, {reading}) < 1);
      }
    }
  }
}

/// What is seen at time 0 conditions the initial belief; no step is taken.
RC_GTEST_PROP(Estimate, TheStartIsConditioned, ()) {
  const Model model = *models({.open = chance(50)});
  const reference::Step slow(model.plant);
  const automata::Observation seen = (*logs(model.plant, 1)).lines.front().observation;
  const reference::Belief initial = reference::initial_belief(slow);
  const auto counted = reference::set_aside(seen, [&](const automata::Observation& rest) {
    return std::any_of(initial.begin(), initial.end(),
                       [&](const auto& entry) { return slow.observation_factor(entry.first.modes, rest) > 0; });
  });
  RC_ASSERT(counted.has_value());
  reference::Belief expected;
  double sum = 0;
  for (const auto& [state, probability] : initial) {
    const double weighed = probability * slow.observation_factor(state.modes, counted->rest);
    if (weighed > 0) sum += expected[state] = weighed;
  }
  for (auto& [state, probability] : expected) probability /= sum;
  for (const bool exact : {true, false}) {
    automata::PlantStep step(model.plant);
    const auto estimator =
        exact ? runtime::make_exact_estimator(step, {})
              : runtime::make_k_best_estimator(step, {.k = everything, .clocks = everything, .patience = 0});
    RC_ASSERT(estimator->start(seen).set_aside == counted->aside);
    same_belief(estimator->belief(), expected);
  }
}

/// Ranks: whole numbers that add up along the best trajectory into each state, and whole sets of equal rank.
RC_GTEST_PROP(Estimate, RanksAreCounted, ()) {
  const Model model = *models();
  const Log log = *logs(model.plant, 5);
  const std::size_t k = up_to(1, 6);
  automata::PlantStep step(model.plant);
  const auto estimator = runtime::make_k_best_estimator(
      step, {.k = k, .merge_trajectories = false, .observation_factor = false, .normalise = false, .ranks = true});
  const reference::Step slow(model.plant);
  reference::Ranks kept = reference::best(reference::initial_ranks(slow), k);
  Ticks before;
  for (const LogLine& line : log.lines) {
    kept = reference::best(reference::ranked(slow, kept, line.action, line.observation, before, line.time), k);
    before = line.time;
    if (kept.empty()) return;
    const runtime::Estimate& estimate = estimator->update(line.action, line.observation, line.time);
    RC_ASSERT(estimate.consistent);
    RC_ASSERT(estimator->belief().size() == kept.size());
    for (const runtime::BeliefEntry& entry : estimator->belief()) {
      const auto known = kept.find(entry.state);
      RC_ASSERT(known != kept.end());
      RC_ASSERT(estimate.rank + static_cast<std::uint64_t>(std::llround(-std::log10(entry.probability))) ==
                known->second);
    }
  }
}

/// What a truncated belief leaves out of the exact posterior is never more than it says, however long it goes on.
RC_GTEST_PROP(Estimate, MissingMassIsAnUpperBound, ()) {
  const Model model = *models({.max_attributes = 6, .open = chance(60)});
  const Log log = chance(50) ? *logs(model.plant, 6) : *resting_logs(model.plant, 3, 8);
  const runtime::EstimatorOptions options{.k = up_to(1, 4),
                                          .clocks = everything,
                                          .patience = chance(50) ? 0 : up_to(1, 32),
                                          .factored = chance(50),
                                          .account = chance(70)};
  automata::PlantStep step(model.plant);
  const auto estimator = runtime::make_k_best_estimator(step, options);
  const reference::Step slow(model.plant);
  reference::Belief exact = reference::initial_belief(slow);
  double sum = 0;
  for (const auto& [state, probability] : exact) sum += probability;
  for (auto& [state, probability] : exact) probability /= sum;
  Ticks before;
  for (const LogLine& line : log.lines) {
    const auto update = reference::belief_update(slow, exact, line.action, line.observation, before, line.time);
    if (!update.follows) return;
    exact = update.belief;
    estimator->update(line.action, line.observation, line.time);
    before = line.time;
    double listed = 0;
    double claimed = 0;
    for (const runtime::BeliefEntry& entry : estimator->belief()) {
      const auto known = exact.find(entry.state);
      listed += known == exact.end() ? 0.0 : known->second;
      claimed += entry.probability;
    }
    const double bound = 1 - (1 - estimator->estimate().missing_total) * std::min(1.0, claimed);
    RC_ASSERT(1 - listed <= bound + 1e-9);
  }
}

/// Clocks that are merged change no more than is said: the belief in each mode combination differs from the exact one
/// by the bound at most, through silences, late repairs and renewals.
RC_GTEST_PROP(Estimate, MergedClocksStayWithinTheBound, ()) {
  const Model model = *models({.max_components = 2, .max_attributes = 3});
  const Log log = *resting_logs(model.plant, 3, 10);
  automata::PlantStep one(model.plant), other(model.plant);
  const auto exact = runtime::make_exact_estimator(one, {.live_clocks_only = true});
  const runtime::EstimatorOptions few{.k = up_to(1, 16), .clocks = up_to(1, 3), .live_clocks_only = chance(50)};
  const auto merged = runtime::make_k_best_estimator(other, few);
  for (const LogLine& line : log.lines) {
    exact->update(line.action, line.observation, line.time);
    merged->update(line.action, line.observation, line.time);
    if (!exact->estimate().follows) return;
    std::map<automata::Modes, double> difference;
    for (const runtime::BeliefEntry& entry : exact->belief()) difference[entry.state.modes] += entry.probability;
    for (const runtime::BeliefEntry& entry : merged->belief()) difference[entry.state.modes] -= entry.probability;
    double apart = 0, listed = 0;
    for (const auto& [modes, by] : difference) apart += std::max(by, 0.0);
    for (const runtime::BeliefEntry& entry : merged->belief()) listed += entry.probability;
    const double bound = std::min(1.0, merged->estimate().missing_total + 1 - std::min(1.0, listed));
    RC_TAG(bound == 0 ? "nothing merged" : bound < 1 ? "within a bound" : "no bound");
    RC_ASSERT(apart <= bound + 1e-9);
    const std::size_t most = std::max(few.k, difference.size()) * few.clocks * model.plant.components.size();
    RC_ASSERT(merged->belief().size() <= most);
  }
}

/// What is not worked out again, because it is known to stay, would be the same to the last bit. Without memories other
/// conflicts may be found, so that another number of candidates is checked.
RC_GTEST_PROP(Estimate, WhatStaysWouldBeTheSame, ()) {
  const Model model = *models({.max_components = 4});
  const Log log = *resting_logs(model.plant, 3, 30);
  const runtime::EstimatorOptions options{.k = chance(50) ? everything : up_to(1, 8),
                                          .factored = chance(80),
                                          .live_clocks_only = chance(70),
                                          .account = chance(30)};
  automata::PlantStep one(model.plant), other(model.plant);
  const auto anew = runtime::make_k_best_estimator(one, options);
  const auto estimator = runtime::make_k_best_estimator(other, options);
  std::size_t stayed = 0;
  for (const LogLine& line : log.lines) {
    const runtime::Belief before = estimator->belief();
    {
      const base::WithoutCaches without;
      anew->update(line.action, line.observation, line.time);
    }
    const runtime::Estimate& found = estimator->update(line.action, line.observation, line.time);
    const runtime::Estimate& expected = anew->estimate();
    RC_ASSERT(!anew->stayed());
    RC_ASSERT(same(estimator->belief(), anew->belief()));
    RC_ASSERT(!estimator->stayed() || same(estimator->belief(), before));
    RC_ASSERT(found.modes == expected.modes);
    RC_ASSERT(found.probability == expected.probability);
    RC_ASSERT(found.consistent == expected.consistent && found.follows == expected.follows);
    RC_ASSERT(found.set_aside == expected.set_aside && found.cut == expected.cut);
    RC_ASSERT(found.missing_mass == expected.missing_mass && found.missing_total == expected.missing_total);
    if (estimator->stayed()) ++stayed;
  }
  RC_TAG(stayed == 0 ? "nothing stayed" : "something stayed");
}

/// The factored belief is the unfactored one.
RC_GTEST_PROP(Estimate, FactoredIsUnfactored, ()) {
  const Model model = *models({.max_components = 4});
  const Log log = *logs(model.plant, 5);
  automata::PlantStep one(model.plant);
  automata::PlantStep other(model.plant);
  const auto whole = runtime::make_exact_estimator(one, {.factored = false});
  const auto parts = runtime::make_exact_estimator(other, {.factored = true});
  RC_TAG(parts->groups());
  for (const LogLine& line : log.lines) {
    const runtime::Estimate& expected = whole->update(line.action, line.observation, line.time);
    const runtime::Estimate& found = parts->update(line.action, line.observation, line.time);
    RC_ASSERT(found.follows == expected.follows);
    if (!expected.follows) return;
    RC_ASSERT(found.set_aside == expected.set_aside);
    RC_ASSERT(std::abs(found.probability - expected.probability) < 1e-9);
    reference::Belief belief;
    for (const runtime::BeliefEntry& entry : whole->belief()) belief[entry.state] = entry.probability;
    same_belief(parts->belief(), belief);
    same_mode(found, belief);
  }
}

/// What is listed of a product is its head, and no more is forgotten: once a control action has contradicted a store
/// and one filter has taken over, it has the whole belief.
RC_GTEST_PROP(Estimate, FactoredListsTheBest, ()) {
  const Model model = *models({.max_components = 4});
  const Log log = *logs(model.plant, 3);
  const std::size_t most = up_to(1, 9);
  automata::PlantStep one(model.plant);
  automata::PlantStep other(model.plant);
  const auto all = runtime::make_exact_estimator(one, {});
  const auto head = runtime::make_exact_estimator(other, {.listed = most});
  if (all->groups() == 1) return;
  for (const LogLine& line : log.lines) {
    all->update(line.action, line.observation, line.time);
    head->update(line.action, line.observation, line.time);
    reference::Belief belief;
    for (const runtime::BeliefEntry& entry : all->belief()) belief[entry.state] = entry.probability;
    if (all->groups() == 1) {
      same_belief(head->belief(), belief);
      continue;
    }
    const reference::Best expected = reference::best(belief, most);
    if (expected.clear) same_belief(head->belief(), expected.belief);
  }
}

RC_GTEST_PROP(Estimate, ThesisModeIsFigure6_11, ()) {
  const Model model = *models();
  const Log log = *logs(model.plant, 5);
  const std::size_t k = chance(50) ? everything : up_to(1, 6);
  automata::PlantStep step(model.plant);
  const auto estimator = runtime::make_k_best_estimator(
      step, {.k = k, .merge_trajectories = false, .observation_factor = false, .normalise = false});
  const reference::Step slow(model.plant);
  reference::Best kept = reference::best(reference::initial_belief(slow), k);
  Ticks before;
  for (const LogLine& line : log.lines) {
    kept = reference::best(reference::timed_me(slow, kept.belief, line.action, line.observation, before, line.time), k);
    before = line.time;
    if (kept.belief.empty() || !kept.clear) return;
    RC_ASSERT(estimator->update(line.action, line.observation, line.time).consistent);
    same_belief(estimator->belief(), kept.belief);
  }
}

/// Twenty sensors over components that exclude each other's modes now and then. What a mode shows is drawn: a value, or
/// anything.
struct Panel {
  runtime::test::PlantWriter writer;
  std::vector<automata::VariableId> sensors;
  std::vector<std::vector<std::optional<std::size_t>>> shows;  ///< by sensor, by mode of its component
  std::vector<std::size_t> component_of;                       ///< by sensor
  std::vector<std::pair<std::size_t, std::size_t>> excluded;   ///< mode 1 of the first with mode 2 of the second
};

Panel draw_panel() {
  constexpr std::size_t sensors = 20;
  constexpr std::size_t values = 3;
  Panel panel;
  auto& w = panel.writer;
  const std::size_t components = up_to(3, 6);
  for (std::size_t s = 0; s < sensors; ++s) {
    panel.sensors.push_back(w.observable("s" + std::to_string(s), {"a", "b", "c"}));
    panel.component_of.push_back(s % components);
    auto& shows = panel.shows.emplace_back();
    for (std::size_t m = 0; m < 3; ++m)
      shows.push_back(chance(15) ? std::nullopt : std::optional(up_to(0, values - 1)));
  }
  for (std::size_t c = 0; c < components; ++c) {
    std::vector<runtime::test::PlantWriter::ModeLine> modes;
    for (std::size_t m = 0; m < 3; ++m) {
      std::vector<automata::Formula> all;
      for (std::size_t s = c; s < sensors; s += components) {
        if (const auto shown = panel.shows[s][m]) {
          all.push_back(automata::is(panel.sensors[s], automata::ValueId(*shown)));
        }
      }
      modes.push_back({"m" + std::to_string(m), m == 2, automata::conjunction(std::move(all))});
    }
    const auto id = w.component("c" + std::to_string(c), modes);
    w.transition(id, "m0", "m1").timing = runtime::test::uniform(0, 4);
    w.fault(id, "m2", 0.01);
    if (c > 0 && chance(60)) panel.excluded.emplace_back(c - 1, c);
  }
  for (const auto& [one, other] : panel.excluded) {
    w.plant.interconnections.push_back(automata::negation(
        automata::conjunction({w.is("c" + std::to_string(one), "m1"), w.is("c" + std::to_string(other), "m2")})));
  }
  return panel;
}

/// What is set aside is the first smallest set by brute force, and the belief is that of the log without it.
RC_GTEST_PROP(Estimate, MadSensorsAreSetAside, ()) {
  const Panel panel = draw_panel();
  const automata::Plant& plant = panel.writer.plant;
  automata::PlantStep one(plant), other(plant), third(plant);
  const auto estimator = runtime::make_exact_estimator(one, {});
  const auto undisturbed = runtime::make_exact_estimator(other, {});
  const auto k_best = runtime::make_k_best_estimator(third, {.k = everything});
  automata::Modes truth(plant.components.size());
  for (std::int64_t step = 1; step <= 3; ++step) {
    for (automata::ModeId& mode : truth) {
      if (mode.value < 2 && chance(30)) mode = automata::ModeId(up_to(1, 2));
    }
    automata::Observation seen;
    for (std::size_t s = 0; s < panel.sensors.size(); ++s) {
      const auto shown = panel.shows[s][truth[panel.component_of[s]].index()];
      seen.push_back({panel.sensors[s], automata::ValueId(shown.value_or(up_to(0, 2)))});
    }
    const std::size_t mad = up_to(1, 3);
    for (std::size_t i = 0; i < mad; ++i) seen[up_to(0, seen.size() - 1)].value = automata::ValueId(up_to(0, 2));
    // Where a step may lead, by the modes alone.
    std::set<automata::Modes> reached;
    for (const runtime::BeliefEntry& entry : undisturbed->belief()) {
      std::vector<std::size_t> sizes(plant.components.size(), 3);
      for (const auto& tuple : reference::tuples(sizes)) {
        bool possible = true;
        for (std::size_t c = 0; c < sizes.size(); ++c) {
          const std::size_t from = entry.state.modes[c].index();
          const auto age = (Ticks{step * Ticks::per_second} - entry.state.clock_starts[c]).count;
          const bool overdue = from == 0 && age >= 4 * Ticks::per_second;
          possible = possible && (tuple[c] >= from && !(overdue && tuple[c] == 0));
        }
        for (const auto& [i, j] : panel.excluded) possible = possible && !(tuple[i] == 1 && tuple[j] == 2);
        if (possible) reached.insert(automata::Modes(tuple.begin(), tuple.end()));
      }
    }
    if (reached.empty()) return;
    const auto counted = reference::set_aside(seen, [&](const automata::Observation& rest) {
      return std::any_of(reached.begin(), reached.end(), [&](const automata::Modes& modes) {
        return std::all_of(rest.begin(), rest.end(), [&](const automata::Assignment& reading) {
          const std::size_t s = reading.variable.index();
          const auto shown = panel.shows[s][modes[panel.component_of[s]].index()];
          return !shown || *shown == reading.value.index();
        });
      });
    });
    RC_ASSERT(counted.has_value());
    RC_TAG(counted->aside.size());
    const Ticks now{step * Ticks::per_second};
    RC_ASSERT(estimator->update({}, seen, now).set_aside == counted->aside);
    RC_ASSERT(k_best->update({}, seen, now).set_aside == counted->aside);
    RC_ASSERT(undisturbed->update({}, counted->rest, now).consistent);
    reference::Belief expected;
    for (const runtime::BeliefEntry& entry : undisturbed->belief()) expected[entry.state] = entry.probability;
    same_belief(estimator->belief(), expected);
    same_belief(k_best->belief(), expected);
  }
}

RC_GTEST_PROP(Estimate, LiveClocksKeepTheModes, ()) {
  const Model model = *models();
  const Log log = *logs(model.plant, 5);
  automata::PlantStep step(model.plant);
  const auto estimator = runtime::make_exact_estimator(step, {.live_clocks_only = true});
  const reference::Step slow(model.plant);
  reference::Belief belief = reference::initial_belief(slow);
  Ticks before;
  for (const LogLine& line : log.lines) {
    const auto update = reference::belief_update(slow, belief, line.action, line.observation, before, line.time);
    if (!update.follows) return;
    belief = update.belief;
    same_mode(estimator->update(line.action, line.observation, line.time), belief);
    before = line.time;
  }
}

}  // namespace
}  // namespace rmpl::property
