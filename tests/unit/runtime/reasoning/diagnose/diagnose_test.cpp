// Diagnoses of one snapshot against enumeration of all fault assignments.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/diagnose.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "automata/logic/theory.hpp"
#include "tests/unit/runtime/reasoning/estimate/estimate_models.hpp"

namespace rmpl::runtime {
namespace {

using namespace rmpl::runtime::test;
using automata::ComponentId;
using automata::ModeId;
using automata::Observation;
using Faults = std::vector<std::pair<ComponentId, ModeId>>;

/// The polybox of de Kleer and Williams in small: three inverters in a row and a buffer beside the last; gates are
/// nominal, or faulty with unknown output. Fault probabilities are `p`.
PlantWriter gates(double p) {
  PlantWriter w;
  for (const std::string wire : {"a", "b", "c", "d", "e"}) w.observable(wire, {"zero", "one"});
  const auto same = [&](const std::string& x, const std::string& y) {
    return automata::equivalence(w.is(x, "one"), w.is(y, "one"));
  };
  const std::vector<std::tuple<std::string, std::string, std::string, bool>> table = {
      {"not1", "a", "b", false}, {"not2", "b", "c", false}, {"not3", "c", "d", false}, {"buffer", "c", "e", true}};
  for (const auto& [name, from, to, passes] : table) {
    const auto relation = passes ? same(from, to) : automata::negation(same(from, to));
    const auto gate = w.component(name, {{"good", false, relation}, {"bad", true}});
    w.fault(gate, "bad", p);
  }
  return w;
}

std::vector<std::vector<std::string>> names(const PlantWriter& w, const Diagnoses& result) {
  std::vector<std::vector<std::string>> all;
  for (const Diagnosis& d : result.diagnoses) {
    auto& diagnosis = all.emplace_back();
    for (const auto& [component, mode] : d.faults) {
      diagnosis.push_back(w.plant[component].name + "=" + w.plant[component].modes[mode.index()].name);
    }
  }
  return all;
}

TEST(Diagnose, NoFaultWhereTheNominalModesExplainAll) {
  const PlantWriter w = gates(0.01);
  const Diagnoses result = diagnose(w.plant, {w.assignment("a", "zero"), w.assignment("d", "one")}, {.k = 1});
  ASSERT_EQ(result.diagnoses.size(), 1u);
  EXPECT_TRUE(result.diagnoses[0].faults.empty());
  EXPECT_NEAR(result.diagnoses[0].probability, std::pow(0.99, 4), 1e-12);
  EXPECT_EQ(result.cardinality, 0u);
  EXPECT_EQ(result.checked, 1u);
}

TEST(Diagnose, AllMinimalIsTheSetOfFewestFaults) {
  const PlantWriter w = gates(0.01);
  // d and e are both wrong: one fault upstream explains them, two downstream would be more.
  const Observation wrong{w.assignment("a", "zero"), w.assignment("d", "zero"), w.assignment("e", "one")};
  DiagnoseOptions options;
  options.all_minimal = true;
  const Diagnoses result = diagnose(w.plant, wrong, options);
  EXPECT_EQ(result.cardinality, 1u);
  using Names = std::vector<std::vector<std::string>>;
  EXPECT_EQ(names(w, result), (Names{{"not2=bad"}, {"not1=bad"}}));
  for (const Diagnosis& d : result.diagnoses) EXPECT_NEAR(d.probability, 0.01 * std::pow(0.99, 3), 1e-12);
}

TEST(Diagnose, NothingExplainsWhatNoModeAllows) {
  PlantWriter w = gates(0.01);
  w.plant.interconnections.push_back(w.is("a", "one"));
  for (const bool all : {false, true}) {
    const Diagnoses result = diagnose(w.plant, {w.assignment("a", "zero")}, {.k = 10, .all_minimal = all});
    EXPECT_TRUE(result.diagnoses.empty());
    EXPECT_EQ(result.cardinality, std::nullopt);
    EXPECT_FALSE(result.cut);
  }
}

TEST(Diagnose, AFaultWithoutTransitionHasItsInitialProbability) {
  PlantWriter w = gates(0.01);
  w.plant.components[0].transitions.clear();
  w.plant.components[0].initial = {0.7, 0.3};
  w.plant.components[1].transitions[0].weight = {automata::Weight::Kind::rate, 2.0};
  const Diagnoses result = diagnose(w.plant, {w.assignment("a", "zero"), w.assignment("c", "one")}, {.k = 2});
  using Names = std::vector<std::vector<std::string>>;
  EXPECT_EQ(names(w, result), (Names{{"not2=bad"}, {"not1=bad", "not2=bad"}}));
  EXPECT_NEAR(result.diagnoses[0].probability, 0.7 * -std::expm1(-2.0) * 0.99 * 0.99, 1e-12);
}

TEST(Diagnose, AFaultMayBeThereAtFirstOrCome) {
  PlantWriter w = gates(0.01);
  w.plant.components[0].initial = {0.7, 0.3};
  const Diagnoses result = diagnose(w.plant, {w.assignment("a", "zero"), w.assignment("b", "zero")}, {.k = 1});
  ASSERT_EQ(result.diagnoses.size(), 1u);
  EXPECT_NEAR(result.diagnoses[0].probability, (0.3 + 0.7 * 0.01) * std::pow(0.99, 3), 1e-12);
}

TEST(Diagnose, ARatioEndsTheListWhereTheRestIsTooUnlikely) {
  const PlantWriter w = gates(0.01);
  // One fault (c is wrong through either of two gates), or two; each fault more is 99 times less likely.
  const Observation wrong{w.assignment("a", "zero"), w.assignment("c", "one")};
  using Names = std::vector<std::vector<std::string>>;
  const Names single{{"not2=bad"}, {"not1=bad"}};
  EXPECT_EQ(names(w, diagnose(w.plant, wrong, {.k = 100, .ratio = 98})), single);
  EXPECT_GT(diagnose(w.plant, wrong, {.k = 100, .ratio = 100}).diagnoses.size(), 2u);
  EXPECT_EQ(diagnose(w.plant, wrong, {.k = 100, .ratio = 1}).diagnoses.size(), 2u) << "what is as likely stays";
  EXPECT_EQ(diagnose(w.plant, wrong, {.k = 1, .ratio = 1e9}).diagnoses.size(), 1u);
}

TEST(Diagnose, TheOrderHoldsWhereProbabilitiesUnderflow) {
  PlantWriter w;
  w.observable("lamp", {"dark", "lit"});
  for (int i = 0; i < 400; ++i) {
    const auto unlikely = w.component("c" + std::to_string(i), {{"good"}, {"bad", true}});
    w.fault(unlikely, "bad", 0.9);
  }
  const auto bulb = w.component("bulb", {{"good", false, w.is("lamp", "lit")}, {"bad", true}});
  w.fault(bulb, "bad", 0.001);
  DiagnoseOptions options;
  options.all_minimal = true;
  const Diagnoses result = diagnose(w.plant, {w.assignment("lamp", "dark")}, options);
  ASSERT_EQ(result.diagnoses.size(), 1u);
  EXPECT_EQ(result.diagnoses[0].probability, 0);
  EXPECT_NEAR(result.diagnoses[0].log_probability, 400 * std::log(0.1) + std::log(0.001), 1e-6);
}

/// All consistent fault assignments, by asking each.
std::vector<std::pair<double, Faults>> enumerate(const automata::Plant& plant, const Observation& observation) {
  automata::PlantStep step(plant);
  std::vector<std::pair<double, Faults>> all;
  automata::Modes modes(plant.components.size());
  std::map<Faults, double> by_faults;
  const auto visit = [&](const auto& self, std::size_t c, double p, const Faults& faults) -> void {
    if (c == modes.size()) {
      if (step.explains(modes, observation)) by_faults[faults] = p;
      return;
    }
    const double stuck = 0.01 * static_cast<double>(c + 1);
    const double failed = 0.002;
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      modes[c] = ModeId(m);
      Faults with = faults;
      if (plant.components[c].modes[m].fault) with.emplace_back(ComponentId(c), ModeId(m));
      self(self, c + 1, p * (m < 3 ? 1 - stuck - failed : m == 3 ? stuck : failed), with);
    }
  };
  visit(visit, 0, 1.0, {});
  for (const auto& [faults, p] : by_faults) all.emplace_back(p, faults);
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  return all;
}

TEST(Diagnose, AgreesWithEnumeration) {
  const PlantWriter w = chain(4);
  for (unsigned pattern = 0; pattern < 32; ++pattern) {
    Observation observation;
    for (std::size_t i = 0; i < w.plant.observables.size(); ++i) {
      observation.push_back({w.plant.observables[i], automata::ValueId((pattern >> i) & 1u)});
    }
    const auto expected = enumerate(w.plant, observation);
    const Diagnoses leading = diagnose(w.plant, observation, {.k = 1000});
    ASSERT_EQ(leading.diagnoses.size(), expected.size());
    std::size_t fewest = 100;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(leading.diagnoses[i].probability, expected[i].first, 1e-12);
      fewest = std::min(fewest, expected[i].second.size());
    }
    const Diagnoses minimal = diagnose(w.plant, observation, {.all_minimal = true});
    EXPECT_EQ(minimal.cardinality, fewest);
    std::vector<Faults> found;
    for (const Diagnosis& d : minimal.diagnoses) found.push_back(d.faults);
    std::vector<Faults> all;
    for (const auto& [p, faults] : expected) {
      if (faults.size() == fewest) all.push_back(faults);
    }
    std::sort(found.begin(), found.end());
    std::sort(all.begin(), all.end());
    EXPECT_EQ(found, all);
  }
}

}  // namespace
}  // namespace rmpl::runtime
