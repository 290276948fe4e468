// The evidence of a diagnosis, on models small enough to see it.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/explain/evidence.hpp"

#include <gtest/gtest.h>

#include "runtime/reasoning/explain/explainer.hpp"
#include "tests/unit/runtime/reasoning/estimate/estimate_models.hpp"

namespace rmpl::runtime {
namespace {

using namespace rmpl::runtime::test;
using automata::ComponentId;

/// A valve under a pump: the flow is there where both work. `flow` is seen, the pressure between them is not.
PlantWriter pumped() {
  PlantWriter w;
  w.control("cmd", {"none", "open"});
  w.observable("flow", {"zero", "full"});
  w.observable("lamp", {"dark", "lit"});
  w.variable("pressure", {"none", "high"});
  w.variable("inlet", {"none", "high"});
  const auto pump =
      w.component("pump", {{"on", false, w.is("pressure", "high")}, {"failed", true, w.is("pressure", "none")}});
  const auto valve = w.component(
      "valve", {{"open", false, automata::equivalence(w.is("inlet", "high"), w.is("flow", "full"))}, {"stuck", true}});
  w.fault(pump, "failed", 0.01);
  w.fault(valve, "stuck", 0.001);
  w.plant.interconnections.push_back(
      automata::equality(*w.plant.variables.find("pressure"), *w.plant.variables.find("inlet")));
  return w;
}

TEST(Evidence, NamesWhatRefutesTheStoryWithoutTheFault) {
  const PlantWriter w = pumped();
  automata::PlantStep step(w.plant);
  const auto estimator = make_k_best_estimator(step, {});
  const automata::Observation seen{w.assignment("flow", "zero"), w.assignment("lamp", "lit")};
  EXPECT_FALSE(estimator->likeliest_without(ComponentId(0), w.mode(ComponentId(0), "failed"), {}));
  const Estimate& estimate = estimator->update(automata::idle_action(w.plant), seen, at(1));
  ASSERT_EQ(estimate.modes[0], w.mode(ComponentId(0), "failed"));
  const auto story = estimator->likeliest_without(ComponentId(0), estimate.modes[0], {});
  ASSERT_TRUE(story);
  EXPECT_EQ(*story, (automata::Modes{w.mode(ComponentId(0), "on"), w.mode(ComponentId(1), "open")}));
  const Evidence evidence = Evidences(w.plant).of(ComponentId(0), estimate.modes, *story, seen);
  EXPECT_EQ(evidence.kind, Evidence::Kind::refuted);
  EXPECT_EQ(evidence.fault, estimate.modes[0]);
  EXPECT_EQ(evidence.readings, std::vector{w.assignment("flow", "zero")});
  EXPECT_EQ(evidence.modes, (std::vector{ComponentId(0), ComponentId(1)}));
  EXPECT_EQ(evidence.interconnections, std::vector<std::size_t>{0});
}

/// A fault that predicts what its nominal mode leaves open is believed once it has been seen often enough.
TEST(Evidence, OutweighsAStoryThatLeavesTheReadingOpen) {
  PlantWriter w;
  w.observable("noise", {"low", "high"});
  const auto sensor = w.component("sensor", {{"works"}, {"humming", true, w.is("noise", "high")}});
  w.fault(sensor, "humming", 0.3);
  automata::PlantStep step(w.plant);
  const auto estimator = make_exact_estimator(step, {});
  const automata::Observation seen{w.assignment("noise", "high")};
  const Estimate* estimate = nullptr;
  for (int i = 1; i <= 2; ++i) estimate = &estimator->update(automata::idle_action(w.plant), seen, at(i));
  ASSERT_EQ(estimate->modes[0], w.mode(ComponentId(0), "humming"));
  const auto story = estimator->likeliest_without(ComponentId(0), estimate->modes[0], {});
  ASSERT_TRUE(story);
  const Evidence evidence = Evidences(w.plant).of(ComponentId(0), estimate->modes, *story, seen);
  EXPECT_EQ(evidence.kind, Evidence::Kind::outweighed);
  EXPECT_EQ(evidence.readings, seen);
  EXPECT_TRUE(evidence.modes.empty());
  const auto told = Explainer(w.plant).evidence_of_new(*story, *estimator, seen);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_DOUBLE_EQ(told[0].ratio, estimate->probability / (1 - estimate->probability));
}

/// Groups that are kept apart tell one story.
TEST(Evidence, TheStoryIsThatOfAllGroups) {
  PlantWriter w;
  for (const std::string name : {"a", "b"}) {
    w.observable(name + "_out", {"zero", "one"});
    const auto c = w.component(name, {{"ok", false, w.is(name + "_out", "one")}, {"broken", true}});
    w.fault(c, "broken", 0.1);
  }
  automata::PlantStep step(w.plant);
  const auto estimator = make_k_best_estimator(step, {});
  ASSERT_EQ(estimator->groups(), 2u);
  const automata::Observation seen{w.assignment("a_out", "one"), w.assignment("b_out", "zero")};
  const Estimate& estimate = estimator->update(automata::idle_action(w.plant), seen, at(1));
  ASSERT_EQ(estimate.modes[1], w.mode(ComponentId(1), "broken"));
  EXPECT_EQ(estimator->likeliest_without(ComponentId(1), estimate.modes[1], {}),
            (automata::Modes{w.mode(ComponentId(0), "ok"), w.mode(ComponentId(1), "ok")}));
  // From then on every state that is tracked has the fault.
  estimator->update(automata::idle_action(w.plant), seen, at(2));
  EXPECT_FALSE(estimator->likeliest_without(ComponentId(1), estimate.modes[1], {}));
}

/// Two units that one constraint links, and which fail at once: each is diagnosed by what it shows itself.
TEST(Explainer, OfSeveralFaultsAtOnceEachHasItsOwnEvidence) {
  PlantWriter w;
  for (const std::string name : {"a", "b"}) {
    w.observable(name + "_out", {"zero", "one"});
    const auto c = w.component(name, {{"ok", false, w.is(name + "_out", "one")}, {"broken", true}});
    w.fault(c, "broken", 0.1);
  }
  w.observable("any", {"zero", "one"});
  w.plant.interconnections.push_back(
      automata::equivalence(w.is("any", "one"), automata::disjunction({w.is("a_out", "one"), w.is("b_out", "one")})));
  automata::PlantStep step(w.plant);
  const auto estimator = make_k_best_estimator(step, {});
  ASSERT_EQ(estimator->groups(), 1u);
  const automata::Modes before = estimator->estimate().modes;
  const automata::Observation seen{w.assignment("a_out", "zero"), w.assignment("b_out", "zero")};
  estimator->update(automata::idle_action(w.plant), seen, at(1));
  const auto found = Explainer(w.plant).evidence_of_new(before, *estimator, seen);
  ASSERT_EQ(found.size(), 2u);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(found[c].component, ComponentId(c));
    EXPECT_EQ(found[c].kind, Evidence::Kind::refuted);
    EXPECT_EQ(found[c].readings, std::vector{seen[c]});
    EXPECT_EQ(found[c].modes, std::vector{ComponentId(c)});
  }
}

/// A mode that is left by a fault alone, and only in that direction, has no other story.
TEST(Explainer, AFaultThatNoStepAvoidsIsToldAsThat) {
  PlantWriter w;
  const auto fuse = w.component("fuse", {{"whole"}, {"blown", true}});
  w.fault(fuse, "blown", 1);
  automata::PlantStep step(w.plant);
  const auto estimator = make_exact_estimator(step, {});
  const automata::Modes before = estimator->estimate().modes;
  estimator->update(automata::idle_action(w.plant), {}, at(1));
  const auto found = Explainer(w.plant).evidence_of_new(before, *estimator, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Evidence::Kind::unavoidable);
  EXPECT_TRUE(Explainer(w.plant).evidence_of_new(estimator->estimate().modes, *estimator, {}).empty());
}

}  // namespace
}  // namespace rmpl::runtime
