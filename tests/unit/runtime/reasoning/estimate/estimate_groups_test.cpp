// Independent groups: what links components, and what does not.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/groups.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "runtime/reasoning/estimate/estimator.hpp"
#include "tests/unit/runtime/reasoning/estimate/estimate_models.hpp"

namespace rmpl::runtime {
namespace {

using automata::PlantStep;
using automata::Ticks;
using test::PlantWriter;

Ticks at(int seconds) { return {seconds * Ticks::per_second}; }

/// Lamps on one switch, each seen by itself.
PlantWriter lamps(const std::vector<std::string>& names) {
  PlantWriter w;
  w.control("cmd", {"none", "on"});
  for (const std::string& name : names) {
    w.observable(name + ".light", {"no", "yes"});
    const auto l = w.component(
        name,
        {{"off", false, w.is(name + ".light", "no")}, {"on", false, w.is(name + ".light", "yes")}, {"broken", true}});
    w.transition(l, "off", "on").guard = w.is("cmd", "on");
    w.transition(l, "on", "broken").weight = {automata::Weight::Kind::probability, 0.125};
  }
  return w;
}

TEST(Groups, AControlThatOnlyGuardsReadLinksNothing) {
  const PlantWriter w = lamps({"left", "right", "rear"});
  const Groups groups(w.plant);
  ASSERT_EQ(groups.size(), 3u);
  for (const Group& group : groups) {
    EXPECT_EQ(group.shape, 0u);
    EXPECT_EQ(groups.plant(group).components.size(), 1u);
    EXPECT_EQ(groups.plant(group).variables.size(), 3u);  // mode, light and switch
    EXPECT_EQ(group.controls, std::vector<std::size_t>{0});
    EXPECT_FALSE(group.constrains_controls);
  }
  const auto parts = groups.divide({w.assignment("right.light", "yes")});
  EXPECT_TRUE(parts[0].empty());
  ASSERT_EQ(parts[1].size(), 1u);
  EXPECT_EQ(w.plant.variables.name(groups[1].variables[parts[1][0].variable.index()]), "right.light");
}

TEST(Groups, WhatNoStoreReadsIsSeenByNoGroup) {
  const PlantWriter w = lamps({"left", "right"});
  const auto parts = Groups(w.plant).divide({w.assignment("cmd", "on")});
  EXPECT_TRUE(parts[0].empty());
  EXPECT_TRUE(parts[1].empty());
  PlantStep step(w.plant);
  const auto estimator = make_k_best_estimator(step, {});
  EXPECT_TRUE(estimator->update(automata::idle_action(w.plant), {w.assignment("cmd", "on")}, at(1)).consistent);
}

TEST(Groups, ConstraintsAndGuardsLink) {
  PlantWriter w = lamps({"left", "right", "rear"});
  w.plant.interconnections.push_back(
      automata::equality(*w.plant.variables.find("left.light"), *w.plant.variables.find("right.light")));
  EXPECT_EQ(Groups(w.plant).size(), 2u);
  w.plant.components[2].transitions.front().guard = w.is("left.light", "no");
  EXPECT_EQ(Groups(w.plant).size(), 1u);
}

TEST(Groups, ShareThePlantWhereTheyAreTheSameButForNames) {
  PlantWriter w = lamps({"left", "right", "rear"});
  w.plant.components[1].transitions.back().weight.value = 0.25;
  const Groups groups(w.plant);
  EXPECT_EQ(groups.shapes().size(), 2u);
  EXPECT_EQ(groups[0].shape, groups[2].shape);
  EXPECT_NE(groups[0].shape, groups[1].shape);
  EXPECT_EQ(groups.plant(groups[1]).components.front().transitions.back().weight.value, 0.25);
}

TEST(Groups, TellWhatSetsPlantsApart) {
  const PlantWriter w = lamps({"left"});
  const auto differs = [&](const std::function<void(automata::Plant&)>& change) {
    automata::Plant other = w.plant;
    change(other);
    return !same_but_for_names(w.plant, other);
  };
  EXPECT_FALSE(differs([](automata::Plant& plant) { plant.name = "other"; }));
  EXPECT_FALSE(differs([](automata::Plant& plant) { plant.components[0].name = plant.components[0].type = "other"; }));
  EXPECT_FALSE(differs([](automata::Plant& plant) { plant.components[0].modes[0].name = "other"; }));
  EXPECT_TRUE(differs([](automata::Plant& plant) { plant.components[0].modes[0].fault = true; }));
  EXPECT_TRUE(
      differs([](automata::Plant& plant) { plant.components[0].modes[0].constraint = automata::constant(true); }));
  EXPECT_TRUE(
      differs([](automata::Plant& plant) { plant.components[0].transitions[0].guard = automata::constant(true); }));
  EXPECT_TRUE(differs([](automata::Plant& plant) { plant.components[0].transitions[0].restart = true; }));
  EXPECT_TRUE(differs([](automata::Plant& plant) {
    plant.components[0].transitions[0].timing = {Ticks{}, at(1), {}};
  }));
  EXPECT_TRUE(differs([](automata::Plant& plant) { plant.components[0].initial[0] = 0.5; }));
  EXPECT_TRUE(differs([](automata::Plant& plant) { plant.controls[0].idle = automata::ValueId(1); }));
  EXPECT_TRUE(differs([](automata::Plant& plant) { plant.observables.clear(); }));
  EXPECT_TRUE(differs([](automata::Plant& plant) { plant.interconnections.emplace_back(automata::constant(true)); }));
}

TEST(Groups, TheBeliefIsAProduct) {
  const std::vector<std::string> names(10, "lamp");
  std::vector<std::string> numbered;
  for (std::size_t i = 0; i < names.size(); ++i) numbered.push_back(names[i] + std::to_string(i));
  const PlantWriter w = lamps(numbered);
  PlantStep step(w.plant);
  EstimatorOptions options;
  options.listed = 3;
  const auto estimator = make_exact_estimator(step, options);
  EXPECT_EQ(estimator->groups(), 10u);
  estimator->update(w.command("cmd", "on"), {}, at(1));
  estimator->update(automata::idle_action(w.plant), {}, at(2));
  ASSERT_EQ(estimator->belief().size(), 3u);
  EXPECT_NEAR(estimator->belief()[0].probability, std::pow(0.875, 10), 1e-12);
  EXPECT_NEAR(estimator->estimate().probability, std::pow(0.875, 10), 1e-12);
  EXPECT_NEAR(estimator->belief()[1].probability, std::pow(0.875, 9) * 0.125, 1e-12);
  // One broken lamp: ties in order of state, in which `on` comes before `broken`.
  EXPECT_EQ(estimator->belief()[1].state.modes[9], automata::ModeId(2));
  EXPECT_EQ(estimator->belief()[2].state.modes[8], automata::ModeId(2));
}

TEST(Groups, MoreStatesThanCanBeCountedAreKeptAndNotListed) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < 64; ++i) names.push_back("lamp" + std::to_string(i));
  const PlantWriter w = lamps(names);
  PlantStep step(w.plant);
  for (const std::size_t listed : {std::size_t{2}, EstimatorOptions{}.listed}) {
    const auto estimator = make_exact_estimator(step, {.listed = listed});
    estimator->update(w.command("cmd", "on"), {}, at(1));
    estimator->update(automata::idle_action(w.plant), {}, at(2));
    EXPECT_NEAR(estimator->estimate().probability, std::pow(0.875, 64), 1e-12);
    if (listed == 2) {
      EXPECT_EQ(estimator->belief().size(), 2u);
    } else {
      EXPECT_THROW(static_cast<void>(estimator->belief()), TooManyStates);
    }
  }
}

TEST(Groups, ACommandThatContradictsAStoreJoinsThem) {
  PlantWriter w = lamps({"left", "right"});
  w.control("other", {"none", "on"});
  w.plant.components[0].modes[0].constraint = automata::conjunction({w.is("left.light", "no"), w.is("other", "none")});
  PlantStep step(w.plant);
  const auto estimator = make_exact_estimator(step, {});
  EXPECT_EQ(estimator->groups(), 2u);
  // The store of `left = off` contradicts it, so that every guard holds, that of the other lamp too.
  estimator->update(w.command("other", "on"), {}, at(1));
  EXPECT_EQ(estimator->groups(), 1u);
  EXPECT_EQ(estimator->estimate().modes[1], automata::ModeId(1));
}

TEST(Groups, WhatOneCannotExplainSetsNothingAsideInTheOthers) {
  const PlantWriter w = lamps({"left", "right"});
  PlantStep step(w.plant);
  const auto estimator = make_exact_estimator(step, {});
  const automata::Observation seen{w.assignment("left.light", "yes"), w.assignment("right.light", "no")};
  const Estimate& estimate = estimator->update(automata::idle_action(w.plant), seen, at(1));
  EXPECT_FALSE(estimate.consistent);
  EXPECT_EQ(estimate.set_aside, (automata::Observation{w.assignment("left.light", "yes")}));
  EXPECT_EQ(estimate.surprised, (std::vector<bool>{true, false}));
  EXPECT_EQ(estimator->belief().size(), 1u);
}

}  // namespace
}  // namespace rmpl::runtime
