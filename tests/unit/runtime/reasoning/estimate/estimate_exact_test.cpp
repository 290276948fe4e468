// Belief update against numbers worked out by hand from the thesis (6.1.3, 6.2.2).
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/unit/runtime/reasoning/estimate/estimate_models.hpp"

namespace rmpl::runtime {
namespace {

using namespace rmpl::runtime::test;
using automata::Modes;
using automata::PlantStep;

constexpr double tolerance = 1e-12;

/// An estimator of a plant of one component, asked by the names of its modes.
class OneComponent {
 public:
  explicit OneComponent(PlantWriter writer, EstimatorOptions options = {})
      : w(std::move(writer)), step(w.plant), estimator(make_exact_estimator(step, options)) {}

  double operator[](const std::string& mode) const { return probability(estimator->belief(), {w.mode({}, mode)}); }
  void idle(double time) { estimator->update(automata::idle_action(w.plant), {}, at(time)); }
  void command(const std::string& value, double time) { estimator->update(w.command("cmd", value), {}, at(time)); }

  const PlantWriter w;
  PlantStep step;
  std::unique_ptr<Estimator> estimator;
};

/// The driver of Fig. 6-4 with the transitions of Table 6.1.
PlantWriter driver() {
  PlantWriter w;
  w.control("cmd", {"none", "on", "off", "reset"});
  const auto d = w.component("driver", {{"off"},
                                        {"turning_on"},
                                        {"on"},
                                        {"turning_off"},
                                        {"resettable", true},
                                        {"resetting_on"},
                                        {"resetting_off"},
                                        {"failed", true}});
  w.transition(d, "off", "turning_on").guard = w.is("cmd", "on");
  w.transition(d, "on", "turning_off").guard = w.is("cmd", "off");
  w.transition(d, "resettable", "resetting_on").guard = w.is("cmd", "reset");
  w.transition(d, "resettable", "resetting_off").guard = w.is("cmd", "off");
  w.transition(d, "turning_on", "on").timing = uniform(0, 0.1);
  w.transition(d, "turning_off", "off").timing = uniform(0, 0.1);
  w.transition(d, "resetting_on", "on").timing = uniform(0, 0.2);
  w.transition(d, "resetting_off", "off").timing = uniform(0, 0.1);
  w.fault(d, "resettable", 0.01, true);
  w.fault(d, "failed", 0.001);
  return w;
}

struct Row {
  std::string from;
  std::string command;
  double seconds;  ///< t_D at the end of the step; it was 0 at its beginning
  std::map<std::string, double> to;
};

TEST(Exact, GivesTheProbabilitiesOfTable61) {
  const double n = 0.989;
  const std::vector<Row> rows = {
      {"off", "on", 1, {{"turning_on", n}, {"resettable", 0.01}, {"failed", 0.001}}},
      {"off", "none", 1, {{"off", n}, {"resettable", 0.01}, {"failed", 0.001}}},
      {"turning_on", "none", 0.05, {{"turning_on", n / 2}, {"on", n / 2}, {"resettable", 0.01}, {"failed", 0.001}}},
      {"turning_on", "none", 0.1, {{"on", n}, {"resettable", 0.01}, {"failed", 0.001}}},
      {"on", "off", 1, {{"turning_off", n}, {"resettable", 0.01}, {"failed", 0.001}}},
      {"on", "none", 1, {{"on", n}, {"resettable", 0.01}, {"failed", 0.001}}},
      {"turning_off",
       "none",
       0.025,
       {{"turning_off", n * 0.75}, {"off", n * 0.25}, {"resettable", 0.01}, {"failed", 0.001}}},
      {"resettable", "none", 1, {{"resettable", 0.999}, {"failed", 0.001}}},
      {"resettable", "reset", 1, {{"resetting_on", 0.999}, {"failed", 0.001}}},
      {"resettable", "off", 1, {{"resetting_off", 0.999}, {"failed", 0.001}}},
      {"resetting_on",
       "none",
       0.05,
       {{"resetting_on", n * 0.75}, {"on", n * 0.25}, {"resettable", 0.01}, {"failed", 0.001}}},
      {"resetting_off",
       "none",
       0.05,
       {{"resetting_off", n / 2}, {"off", n / 2}, {"resettable", 0.01}, {"failed", 0.001}}},
      {"failed", "reset", 1, {{"failed", 1}}},
  };
  for (const Row& row : rows) {
    PlantWriter w = driver();
    auto& initial = w.plant.components[0].initial;
    initial.assign(initial.size(), 0.0);
    initial[w.mode({}, row.from).index()] = 1;
    OneComponent driver(std::move(w));
    driver.command(row.command, row.seconds);
    for (const automata::Mode& mode : driver.w.plant.components[0].modes) {
      const auto expected = row.to.find(mode.name);
      EXPECT_NEAR(driver[mode.name], expected == row.to.end() ? 0.0 : expected->second, tolerance)
          << row.from << " -> " << mode.name << " under " << row.command;
    }
  }
}

TEST(Exact, FollowsTheTrellisOfFig68) {
  OneComponent engine(test::engine());
  EXPECT_EQ(engine["off"], 1.0);
  const double t1 = 1;
  const double n = 0.999;
  engine.command("standby", t1);
  EXPECT_NEAR(engine["heating"], n, tolerance);
  EXPECT_NEAR(engine["failed"], 1 - n, tolerance);
  engine.idle(t1 + 30);  // the clock reaches the lower bound: nothing yet
  EXPECT_NEAR(engine["heating"], n * n, tolerance);
  EXPECT_EQ(engine["standby"], 0.0);
  engine.idle(t1 + 40);  // a third of the interval
  EXPECT_NEAR(engine["standby"], std::pow(n, 3) / 3, tolerance);
  EXPECT_NEAR(engine["heating"], std::pow(n, 3) * 2 / 3, tolerance);
  engine.idle(t1 + 50);  // half of what was left
  EXPECT_NEAR(engine["standby"], std::pow(n, 4) * 2 / 3, tolerance);
  EXPECT_NEAR(engine["heating"], std::pow(n, 4) / 3, tolerance);
  EXPECT_NEAR(engine["failed"], 1 - std::pow(n, 4), tolerance);
  // A failed state for each time of failure, a standby state for each time of entering it, and heating.
  EXPECT_EQ(engine.estimator->belief().size(), 4u + 2u + 1u);
  EXPECT_EQ(engine.estimator->estimate().modes, Modes{engine.w.mode({}, "standby")});
  EXPECT_NEAR(engine.estimator->estimate().probability, std::pow(n, 4) * 2 / 3, tolerance);
  engine.idle(t1 + 60);  // the upper bound: certain, but for the fault
  EXPECT_EQ(engine["heating"], 0.0);
  EXPECT_NEAR(engine["standby"], std::pow(n, 5), tolerance);
}

TEST(Exact, FollowsTheTrellisOfFig69) {
  OneComponent engine(test::engine());
  const double n = 0.999;
  const double dt = 5;
  engine.command("standby", 1);
  engine.idle(31);
  for (int i = 1; i <= 3; ++i) engine.idle(31 + i * dt);
  EXPECT_NEAR(engine["standby"], std::pow(n, 5) / 2, tolerance);
  EXPECT_NEAR(engine["heating"], std::pow(n, 5) / 2, tolerance);
  engine.command("off", 31 + 4 * dt);  // from both modes
  EXPECT_NEAR(engine["off"], std::pow(n, 6), tolerance);
  EXPECT_EQ(engine["heating"], 0.0);
  EXPECT_EQ(engine["standby"], 0.0);
  EXPECT_NEAR(engine["failed"], 1 - std::pow(n, 6), tolerance);
}

TEST(Exact, WeighsStatesByWhatTheyPredict) {
  OneComponent engine(test::engine());
  engine.command("standby", 1);
  // Heating and failed say nothing of the temperature: both get 1/2, and keep their ratio.
  engine.estimator->update(automata::idle_action(engine.w.plant), {engine.w.assignment("temp", "low")}, at(2));
  EXPECT_NEAR(engine["heating"], std::pow(0.999, 2), tolerance);
  // At 41 s a third is in standby, which predicts what is seen.
  engine.estimator->update(automata::idle_action(engine.w.plant), {engine.w.assignment("temp", "nominal")}, at(41));
  const double standby = std::pow(0.999, 3) / 3;
  const double heating = std::pow(0.999, 3) * 2 / 3 / 2;
  const double failed = (1 - std::pow(0.999, 3)) / 2;
  const double sum = standby + heating + failed;
  EXPECT_NEAR(engine["standby"], standby / sum, tolerance);
  EXPECT_NEAR(engine["heating"], heating / sum, tolerance);
  EXPECT_NEAR(engine["failed"], failed / sum, tolerance);
}

TEST(Exact, ForgetsClocksOnDemand) {
  EstimatorOptions options;
  options.live_clocks_only = true;
  OneComponent engine(test::engine(), options);
  engine.command("standby", 1);
  for (int i = 2; i <= 50; ++i) engine.idle(i);
  EXPECT_EQ(engine.estimator->belief().size(), 3u);
  EXPECT_NEAR(engine["standby"], std::pow(0.999, 50) * 19 / 30, tolerance);
}

/// A lamp that is dark when off and lit when on: no fault explains light that was not asked for.
PlantWriter lamp() {
  PlantWriter w;
  w.control("cmd", {"none", "on"});
  w.observable("light", {"no", "yes"});
  const auto l = w.component("lamp", {{"off", false, w.is("light", "no")}, {"on", false, w.is("light", "yes")}});
  w.transition(l, "off", "on").guard = w.is("cmd", "on");
  return w;
}

TEST(Exact, AnUnexplainedObservationLeavesThePrediction) {
  OneComponent lamp(::rmpl::runtime::lamp());
  lamp.estimator->update(automata::idle_action(lamp.w.plant), {lamp.w.assignment("light", "yes")}, at(1));
  EXPECT_FALSE(lamp.estimator->estimate().consistent);
  EXPECT_EQ(lamp["off"], 1.0);
  lamp.estimator->update(lamp.w.command("cmd", "on"), {lamp.w.assignment("light", "no")}, at(2));
  EXPECT_FALSE(lamp.estimator->estimate().consistent);
  EXPECT_EQ(lamp["on"], 1.0);
  lamp.estimator->update(automata::idle_action(lamp.w.plant), {lamp.w.assignment("light", "yes")}, at(3));
  EXPECT_TRUE(lamp.estimator->estimate().consistent);
  EXPECT_EQ(lamp["on"], 1.0);
}

TEST(Exact, APlantWithoutAPossibleInitialStateIsInconsistentFromTheStart) {
  PlantWriter w = lamp();
  w.plant.interconnections.push_back(w.is("light", "yes"));
  OneComponent lamp(std::move(w));
  EXPECT_FALSE(lamp.estimator->estimate().consistent);
  EXPECT_TRUE(lamp.estimator->belief().empty());
  EXPECT_EQ(lamp.estimator->estimate().modes, Modes{lamp.w.mode({}, "off")});
  lamp.idle(1);
  EXPECT_FALSE(lamp.estimator->estimate().consistent);
}

}  // namespace
}  // namespace rmpl::runtime
