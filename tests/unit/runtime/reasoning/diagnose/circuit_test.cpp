// Minimum-cardinality diagnoses of circuits against enumeration of all sets of gates.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/circuit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>

#include "runtime/reasoning/diagnose/diagnose.hpp"
#include "runtime/reasoning/diagnose/minimal.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;
using automata::Formula;
using automata::ValueId;
using automata::VariableId;

/// A random circuit of two-input gates. Nets 0 … inputs-1 are inputs; gate g drives net inputs + g.
struct RandomCircuit {
  RandomCircuit(std::mt19937& random, std::size_t inputs, std::size_t gates) {
    for (std::size_t n = 0; n < inputs + gates; ++n) {
      nets.push_back(plant.variables.add({"n" + std::to_string(n), {"false", "true"}}));
    }
    for (std::size_t g = 0; g < gates; ++g) {
      const std::size_t kind = random() % 4;
      const std::array pins{random() % (inputs + g), random() % (inputs + g)};
      kinds.push_back(kind);
      sources.push_back({pins[0], pins[1]});
      const Formula a = automata::is(nets[pins[0]], ValueId(1));
      const Formula b = automata::is(nets[pins[1]], ValueId(1));
      const Formula function = kind == 0   ? automata::conjunction({a, b})
                               : kind == 1 ? automata::disjunction({a, b})
                               : kind == 2 ? automata::negation(automata::equivalence(a, b))
                                           : automata::negation(a);
      automata::Component gate;
      gate.name = "g" + std::to_string(g);
      gate.mode = plant.variables.add({gate.name, {"ok", "faulty"}});
      gate.modes.resize(2);
      gate.modes[0].constraint = automata::equivalence(automata::is(nets[inputs + g], ValueId(1)), function);
      gate.modes[1].fault = true;
      gate.initial = {1, 0};
      plant.components.push_back(gate);
    }
  }

  /// The value of every net where the gates in `faulty` drive the bits of `forced`.
  [[nodiscard]] std::vector<bool> simulate(std::vector<bool> values, std::size_t faulty, std::size_t forced) const {
    for (std::size_t g = 0; g < kinds.size(); ++g) {
      const bool a = values[sources[g].first];
      const bool b = values[sources[g].second];
      const bool works = kinds[g] == 0 ? a && b : kinds[g] == 1 ? a || b : kinds[g] == 2 ? a != b : !a;
      values.push_back(((faulty >> g) & 1) != 0 ? ((forced >> g) & 1) != 0 : works);
    }
    return values;
  }

  automata::Plant plant;
  std::vector<VariableId> nets;
  std::vector<std::size_t> kinds;
  std::vector<std::pair<std::size_t, std::size_t>> sources;
};

TEST(Circuit, CompleteSetsEqualEnumeration) {
  std::mt19937 random(20031);
  for (int round = 0; round < 300; ++round) {
    const std::size_t inputs = 2 + random() % 3;
    const std::size_t gates = 4 + random() % 6;
    const RandomCircuit made(random, inputs, gates);
    const auto circuit = circuit_of(made.plant);
    ASSERT_TRUE(circuit);
    std::vector<bool> given;
    for (std::size_t i = 0; i < inputs; ++i) given.push_back(random() % 2 == 0);
    // What some faulty circuit shows on some of its nets.
    const auto shown = made.simulate(given, random() % (1u << gates), random());
    std::vector<std::size_t> watched;
    for (std::size_t n = inputs; n < shown.size(); ++n) {
      if (random() % 3 == 0 || n + 1 == shown.size()) watched.push_back(n);
    }
    std::vector<Assignment> observation;
    for (std::size_t i = 0; i < inputs; ++i) observation.push_back({made.nets[i], ValueId(given[i] ? 1 : 0)});
    for (const std::size_t n : watched) observation.push_back({made.nets[n], ValueId(shown[n] ? 1 : 0)});

    std::set<std::size_t> expected;
    std::size_t fewest = gates + 1;
    for (std::size_t faulty = 0; faulty < (1u << gates); ++faulty) {
      const auto faults = static_cast<std::size_t>(__builtin_popcountll(faulty));
      if (faults > fewest) continue;
      bool explains = false;
      for (std::size_t forced = faulty;; forced = (forced - 1) & faulty) {
        const auto values = made.simulate(given, faulty, forced);
        bool same = true;
        for (const std::size_t n : watched) same = same && values[n] == shown[n];
        explains = explains || same;
        if (forced == 0) break;
      }
      if (!explains) continue;
      if (faults < fewest) expected.clear();
      fewest = faults;
      expected.insert(faulty);
    }

    std::set<std::size_t> found;
    CircuitDiagnosis diagnosis(*circuit);
    const auto result = diagnosis.solve(observation, CircuitDiagnosis::Scope::list, [&](const FaultSet& faults) {
      std::size_t bits = 0;
      for (const auto component : faults) bits |= std::size_t{1} << component.index();
      EXPECT_TRUE(found.insert(bits).second) << "a diagnosis twice";
    });
    ASSERT_TRUE(result) << "round " << round;
    EXPECT_EQ(result->cardinality, fewest) << "round " << round;
    EXPECT_EQ(found, expected) << "round " << round;
    EXPECT_EQ(result->count, found.size()) << "round " << round;
    const auto counted = diagnosis.solve(observation, CircuitDiagnosis::Scope::count, nullptr);
    EXPECT_EQ(counted->count, found.size());
    std::size_t one = 0;
    const auto first = diagnosis.solve(observation, CircuitDiagnosis::Scope::first, [&](const FaultSet& faults) {
      for (const auto component : faults) one |= std::size_t{1} << component.index();
    });
    EXPECT_EQ(first->cardinality, fewest);
    EXPECT_TRUE(expected.contains(one));
  }
}

/// Where all gates are equally likely to fail, one with the fewest faults is one of the most probable.
TEST(Circuit, TheMostProbableDiagnosisHasTheFewestFaults) {
  std::mt19937 random(1981);
  for (int round = 0; round < 60; ++round) {
    RandomCircuit made(random, 3, 7);
    for (automata::Component& gate : made.plant.components) {
      automata::Transition fails;
      fails.from = automata::ModeId(0);
      fails.to = automata::ModeId(1);
      fails.weight = {automata::Weight::Kind::probability, 0.01};
      gate.transitions.push_back(fails);
    }
    const auto shown = made.simulate({random() % 2 == 0, true, false}, random() % (1u << 7), random());
    std::vector<Assignment> observation;
    for (const std::size_t n : {0u, 1u, 2u, 8u, 9u}) observation.push_back({made.nets[n], ValueId(shown[n] ? 1 : 0)});
    const Diagnoses one = diagnose(made.plant, observation, {.k = 1});
    const Diagnoses more = diagnose(made.plant, observation, {.k = 2});
    ASSERT_EQ(one.diagnoses.size(), 1u);
    EXPECT_NEAR(one.diagnoses[0].probability, more.diagnoses[0].probability, 1e-12) << "round " << round;
    EXPECT_EQ(one.cardinality, more.diagnoses[0].faults.size());
  }
}

TEST(Circuit, WhatIsNoCircuitIsRecognised) {
  std::mt19937 random(7);
  RandomCircuit made(random, 2, 3);
  EXPECT_TRUE(circuit_of(made.plant));
  auto looped = made.plant;
  looped.interconnections.push_back(automata::equality(made.nets[2], made.nets[3]));
  EXPECT_FALSE(circuit_of(looped)) << "a net driven twice";
  auto strong = made.plant;
  strong.components[0].modes[1].constraint = automata::is(made.nets[2], ValueId(0));
  EXPECT_FALSE(circuit_of(strong)) << "a constrained fault";
  auto constrained = made.plant;
  constrained.interconnections.push_back(automata::is(made.nets[0], ValueId(0)));
  EXPECT_FALSE(circuit_of(constrained)) << "an interconnection that is no equality";
}

}  // namespace
}  // namespace rmpl::runtime
