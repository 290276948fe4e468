// The k-best estimator against the exact one, and against enumeration from its own belief.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

#include "automata/clock_use.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "tests/unit/runtime/reasoning/estimate/estimate_models.hpp"

namespace rmpl::runtime {
namespace {

using namespace rmpl::runtime::test;
using automata::ControlAction;
using automata::Modes;
using automata::Observation;
using automata::PlantStep;
using automata::SystemState;
using automata::Ticks;

constexpr double tolerance = 1e-12;

/// Commands and readings that some behaviour of the chain explains, most of the time.
class Story {
 public:
  Story(const PlantWriter& writer, std::uint32_t seed) : w_(writer), random_(seed) {}

  void next() {
    time_ += Ticks{static_cast<std::int64_t>(1 + random_() % 4) * Ticks::per_second / 2};
    action = random_() % 3 == 0 ? w_.command("cmd", "close") : automata::idle_action(w_.plant);
    observation.clear();
    for (const automata::VariableId wire : w_.plant.observables) {
      if (random_() % 3 == 0) observation.push_back({wire, automata::ValueId(random_() % 4 == 0 ? 1u : 0u)});
    }
  }
  [[nodiscard]] Ticks now() const { return time_; }

  ControlAction action;
  Observation observation;

 private:
  const PlantWriter& w_;
  std::mt19937 random_;
  Ticks time_;
};

/// The unnormalised posterior that follows from a belief, all of it, best first; without merging the best trajectory.
Belief posterior(PlantStep& step, const Belief& belief, const ControlAction& action, const Observation& observation,
                 Ticks before, Ticks now, const EstimatorOptions& options) {
  std::map<SystemState, double> targets;
  for (const BeliefEntry& entry : belief) {
    const auto moves = step.moves(entry.state, action, before, now);
    Modes next(moves.size());
    const auto visit = [&](const auto& self, std::size_t c) -> void {
      if (c < moves.size()) {
        for (const auto& move : moves[c]) {
          next[c] = move.mode;
          self(self, c + 1);
        }
        return;
      }
      const double p = entry.probability * step.probability(entry.state, action, before, now, next);
      SystemState to = step.advance(entry.state, action, next, now);
      for (std::size_t i = 0; options.live_clocks_only && i < next.size(); ++i) {
        if (!automata::needs_clock(step.plant().components[i], next[i])) to.clock_starts[i] = {};
      }
      double& target = targets[to];
      target = options.merge_trajectories ? target + p : std::max(target, p);
    };
    visit(visit, 0);
  }
  Belief all;
  for (const auto& [state, p] : targets) {
    const double factor = step.observation_factor(state.modes, observation);
    if (factor > 0) all.push_back({state, p * (options.observation_factor ? factor : 1.0)});
  }
  put_in_order(all);
  return all;
}

/// The states of the k best mode combinations.
void keep_best_modes(Belief& belief, std::size_t k) {
  std::map<Modes, double> sums;
  for (const BeliefEntry& entry : belief) sums[entry.state.modes] += entry.probability;
  Belief best;
  for (const auto& [modes, sum] : sums) best.push_back({{modes, {}}, sum});
  put_in_order(best);
  if (best.size() > k) best.resize(k);
  std::erase_if(belief, [&](const BeliefEntry& entry) {
    return std::none_of(best.begin(), best.end(),
                        [&](const BeliefEntry& kept) { return kept.state.modes == entry.state.modes; });
  });
}

void expect_same(const Belief& actual, const Belief& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_EQ(actual[i].state, expected[i].state) << "place " << i;
    EXPECT_NEAR(actual[i].probability, expected[i].probability, tolerance) << "place " << i;
  }
}

TEST(KBest, EqualsTheExactBeliefWhereKCoversIt) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const PlantWriter w = chain(2);
    PlantStep step(w.plant);
    EstimatorOptions options;
    options.k = 100000;
    options.live_clocks_only = seed % 2 == 0;
    const auto exact = make_exact_estimator(step, options);
    const auto k_best = make_k_best_estimator(step, options);
    expect_same(k_best->belief(), exact->belief());
    Story story(w, seed);
    for (int cycle = 0; cycle < 8; ++cycle) {
      story.next();
      const Estimate& a = exact->update(story.action, story.observation, story.now());
      const Estimate& b = k_best->update(story.action, story.observation, story.now());
      ASSERT_EQ(a.consistent, b.consistent);
      EXPECT_EQ(a.modes, b.modes);
      EXPECT_NEAR(a.probability, b.probability, tolerance);
      EXPECT_EQ(b.missing_mass, 0.0);
      expect_same(k_best->belief(), exact->belief());
    }
  }
}

TEST(KBest, KeepsTheBestOfWhatFollowsFromItsBelief) {
  for (const bool thesis : {false, true}) {
    for (const std::size_t k : {1u, 2u, 5u, 16u}) {
      const PlantWriter w = chain(3);
      PlantStep step(w.plant);
      EstimatorOptions options;
      options.k = k;
      options.merge_trajectories = options.observation_factor = options.normalise = !thesis;
      options.live_clocks_only = !thesis;
      const auto k_best = make_k_best_estimator(step, options);
      Story story(w, static_cast<std::uint32_t>(k));
      std::size_t consistent = 0;
      for (int cycle = 0; cycle < 25; ++cycle) {
        const Ticks before = story.now();
        story.next();
        Belief expected =
            posterior(step, k_best->belief(), story.action, story.observation, before, story.now(), options);
        const Estimate& estimate = k_best->update(story.action, story.observation, story.now());
        ASSERT_EQ(estimate.consistent, !expected.empty());
        if (expected.empty()) continue;
        ++consistent;
        const double whole = total(expected);
        if (!thesis) {
          keep_best_modes(expected, k);
        } else if (expected.size() > k) {
          expected.resize(k);
        }
        EXPECT_GE(estimate.missing_mass * (1 + tolerance), 1 - total(expected) / whole - tolerance);
        EXPECT_LE(estimate.missing_mass, 1.0);
        if (options.normalise) normalise(expected);
        expect_same(k_best->belief(), expected);
      }
      EXPECT_GT(consistent, 10u);
    }
  }
}

/// The belief is at rest for three steps, as only its weights change. Then a state that was known all along, as it is
/// likelier than each single way into c and d, is among the best: entered as the last of these steps ended.
TEST(KBest, WhatIsEnteredAfterARestIsEnteredThen) {
  PlantWriter w;
  w.observable("light", {"no", "yes"});
  const auto dark = w.is("light", "no");
  const auto x = w.component("x", {{"a", false, dark},
                                   {"b", false, dark},
                                   {"c", false, dark},
                                   {"d", false, dark},
                                   {"lit", true, w.is("light", "yes")}});
  w.plant.components[x.index()].initial = {5.0 / 7, 0, 1.0 / 7, 1.0 / 7, 0};
  const auto branch = [&](const std::string& from, const std::string& to, double probability) {
    w.transition(x, from, to).weight = {automata::Weight::Kind::probability, probability};
  };
  branch("a", "a", 0.9);
  branch("a", "b", 0.1);
  for (const std::string from : {"c", "d"}) {
    branch(from, "c", 0.4);
    branch(from, "d", 0.4);
    branch(from, "lit", 0.2);
  }
  w.transition(x, "b", "a").timing = uniform(100, 200);
  PlantStep step(w.plant);
  EstimatorOptions options;
  options.k = 3;
  options.live_clocks_only = true;
  const auto k_best = make_k_best_estimator(step, options);
  const Observation seen = {w.assignment("light", "no")};
  for (int cycle = 1; cycle <= 6; ++cycle) {
    k_best->update({}, seen, at(cycle));
    const auto entered = std::find_if(k_best->belief().begin(), k_best->belief().end(),
                                      [&](const BeliefEntry& entry) { return entry.state.modes[0] == w.mode(x, "b"); });
    ASSERT_EQ(entered != k_best->belief().end(), cycle >= 5) << "cycle " << cycle;
    if (cycle == 5) {
      EXPECT_EQ(entered->state.clock_starts[0], at(5));
    }
  }
}

/// A link of which nothing is read for two hours, a minute a step: it may have gone down at any of them, so that its
/// clock has some seventy values. Of sixteen combinations there are two, and what the others might have had is enough.
TEST(KBest, FewCombinationsHaveManyClocks) {
  PlantWriter w;
  const auto link = w.component("link", {{"up"}, {"down", true}});
  w.fault(link, "down", 0.1, true);
  w.transition(link, "down", "up").timing = uniform(3000, 4200);
  PlantStep step(w.plant);
  EstimatorOptions options;
  options.live_clocks_only = true;
  const auto most = [&](std::size_t k) {
    options.k = k;
    const auto k_best = make_k_best_estimator(step, options);
    std::size_t clocks = 0;
    for (int minute = 1; minute <= 120; ++minute) {
      k_best->update({}, {}, at(60 * minute));
      clocks = std::max(clocks, k_best->belief().size());
    }
    return std::pair(clocks, k_best->estimate().missing_total);
  };
  EXPECT_EQ(most(16), std::pair(std::size_t{71}, 0.0));
  EXPECT_EQ(most(2).first, 65u);
  EXPECT_GT(most(2).second, 0);
}

TEST(KBest, TheThesisNumbersAreTheBestTrajectories) {
  PlantWriter w = engine();
  PlantStep step(w.plant);
  EstimatorOptions options;
  options.k = 3;
  options.merge_trajectories = options.observation_factor = options.normalise = false;
  const auto estimator = make_k_best_estimator(step, options);
  estimator->update(w.command("cmd", "standby"), {}, at(1));
  estimator->update(automata::idle_action(w.plant), {}, at(31));
  // Of a third in standby and two thirds heating, each times 0.999^3, neither is normalised; neither is the failure at
  // the first step, which stays what it is.
  estimator->update(automata::idle_action(w.plant), {w.assignment("temp", "nominal")}, at(41));
  const Belief& belief = estimator->belief();
  ASSERT_EQ(belief.size(), 3u);
  EXPECT_EQ(belief[0].state.modes, Modes{w.mode({}, "heating")});
  EXPECT_NEAR(belief[0].probability, std::pow(0.999, 3) * 2 / 3, tolerance);
  EXPECT_EQ(belief[0].state.clock_starts, std::vector<Ticks>{at(1)});
  EXPECT_EQ(belief[1].state.modes, Modes{w.mode({}, "standby")});
  EXPECT_NEAR(belief[1].probability, std::pow(0.999, 3) / 3, tolerance);
  EXPECT_EQ(belief[1].state.clock_starts, std::vector<Ticks>{at(41)});
  EXPECT_EQ(belief[2].state.modes, Modes{w.mode({}, "failed")});
  EXPECT_NEAR(belief[2].probability, 0.001, tolerance);
  EXPECT_EQ(belief[2].state.clock_starts, std::vector<Ticks>{at(1)});
}

TEST(KBest, UnnormalisedNumbersDoNotVanish) {
  PlantWriter w;
  const auto coin = w.component("coin", {{"heads"}, {"tails"}});
  for (const std::string from : {"heads", "tails"}) {
    for (const std::string to : {"heads", "tails"}) {
      w.transition(coin, from, to).weight = {automata::Weight::Kind::probability, 0.5};
    }
  }
  PlantStep step(w.plant);
  EstimatorOptions options;
  options.k = 2;
  options.merge_trajectories = options.observation_factor = options.normalise = false;
  const auto estimator = make_k_best_estimator(step, options);
  for (int i = 1; i <= 2000; ++i) ASSERT_TRUE(estimator->update({}, {}, at(i)).consistent);
  EXPECT_GT(estimator->belief()[0].probability, 0.0);
}

/// Two lamps on one switch; what they show follows from their modes, and no fault explains a dark one.
PlantWriter lamps() {
  PlantWriter w;
  w.control("cmd", {"none", "on"});
  for (const std::string name : {"left", "right"}) {
    w.observable(name + ".light", {"no", "yes"});
    const auto l = w.component(name, {{"off", false, w.is(name + ".light", "no")},
                                      {"on", false, w.is(name + ".light", "yes")},
                                      {"worn", true, w.is(name + ".light", "yes")}});
    w.transition(l, "off", "on").guard = w.is("cmd", "on");
    w.transition(l, "on", "worn").weight = {automata::Weight::Kind::probability, 0.1};
  }
  return w;
}

TEST(KBest, WidensWhileNothingExplainsTheObservations) {
  PlantWriter w = lamps();
  PlantStep step(w.plant);
  EstimatorOptions options;
  options.k = 1;
  options.factored = false;
  const auto estimator = make_k_best_estimator(step, options);
  const Observation dark{w.assignment("left.light", "no")};
  estimator->update(w.command("cmd", "on"), {}, at(1));
  EXPECT_EQ(estimator->belief().size(), 1u);
  EXPECT_FALSE(estimator->update(automata::idle_action(w.plant), dark, at(2)).consistent);
  EXPECT_EQ(estimator->belief().size(), 2u);
  EXPECT_EQ(estimator->estimate().modes, (Modes{w.mode({}, "on"), w.mode({}, "on")}));
  EXPECT_FALSE(estimator->update(automata::idle_action(w.plant), dark, at(3)).consistent);
  EXPECT_GE(estimator->belief().size(), 4u);
  EXPECT_TRUE(std::is_sorted(estimator->belief().begin(), estimator->belief().end(),
                             [](const auto& a, const auto& b) { return a.probability > b.probability; }));
  EXPECT_TRUE(estimator->update(automata::idle_action(w.plant), {}, at(4)).consistent);
  EXPECT_EQ(estimator->belief().size(), 1u);
}

TEST(KBest, SaysSoWhereItsLimitCutsTheSearch) {
  const PlantWriter w = chain(4);
  PlantStep step(w.plant);
  EstimatorOptions options;
  options.candidates = 3;
  const auto estimator = make_k_best_estimator(step, options);
  const Estimate& estimate = estimator->update(w.command("cmd", "close"), {}, at(1));
  EXPECT_TRUE(estimate.cut);
  EXPECT_EQ(estimate.checked, 3u);
  EXPECT_GT(estimate.missing_mass, 0.0);
}

TEST(KBest, KeepsWhatItFoundByItsDeadline) {
  const PlantWriter w = chain(4);
  PlantStep step(w.plant);
  EstimatorOptions options;
  options.deadline = std::chrono::nanoseconds(1);
  const auto estimator = make_k_best_estimator(step, options);
  const Estimate& estimate = estimator->update(w.command("cmd", "close"), {}, at(1));
  EXPECT_TRUE(estimate.cut);
  EXPECT_TRUE(estimate.consistent);
  EXPECT_EQ(estimator->belief().size(), 1u);
  EXPECT_GT(estimate.missing_total, 0.0);
}

/// Faults of which each that is kept is a source of its own. A target of several sources has all their faults, so that
/// what these have left does not add up at one target.
TEST(KBest, KnowsThatTheBoundsOfSeveralSourcesAreNotAboutOneState) {
  PlantWriter w;
  double probability = 0.001;
  for (const std::string name : {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l"}) {
    w.fault(w.component(name, {{"ok"}, {"broken", true}}), "broken", probability);
    probability *= 1.3;
  }
  automata::PlantStep step(w.plant);
  const auto estimator = make_k_best_estimator(step, {.k = 64, .factored = false});
  std::size_t checked = 0;
  for (int i = 1; i <= 4; ++i) checked += estimator->update(automata::idle_action(w.plant), {}, at(i)).checked;
  EXPECT_LE(checked, 250u);  // 518 by their sum
}

TEST(KBest, RepeatsToTheBit) {
  const PlantWriter w = chain(4);
  std::vector<Belief> runs;
  for (int run = 0; run < 2; ++run) {
    PlantStep step(w.plant);
    const auto estimator = make_k_best_estimator(step, {});
    Story story(w, 3);
    for (int cycle = 0; cycle < 30; ++cycle) {
      story.next();
      estimator->update(story.action, story.observation, story.now());
    }
    runs.push_back(estimator->belief());
  }
  ASSERT_EQ(runs[0].size(), runs[1].size());
  for (std::size_t i = 0; i < runs[0].size(); ++i) {
    EXPECT_EQ(runs[0][i].state, runs[1][i].state);
    EXPECT_EQ(runs[0][i].probability, runs[1][i].probability);
  }
}

}  // namespace
}  // namespace rmpl::runtime
