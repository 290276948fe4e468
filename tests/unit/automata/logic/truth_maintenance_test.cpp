// Truth maintenance against a solver that is asked afresh.
// SPDX-License-Identifier: MIT
#include "automata/logic/truth_maintenance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace rmpl::automata {
namespace {

using Clause = std::vector<Literal>;
using Answer = TruthMaintenance::Answer;

bool satisfied(const Clause& clause, const TruthMaintenance& maintenance) {
  return std::any_of(clause.begin(), clause.end(), [&](Literal l) { return maintenance.value(l); });
}

TEST(TruthMaintenance, AnswersAsASolverDoes) {
  std::mt19937 random(5);
  const auto draw = [&](std::uint32_t below) { return static_cast<int>(random() % below); };
  for (int round = 0; round < 60; ++round) {
    constexpr int variables = 20;
    TruthMaintenance maintenance;
    Sat solver;
    for (int v = 0; v < variables; ++v) maintenance.reserve(static_cast<std::uint32_t>(solver.fresh()));
    std::vector<Clause> clauses;
    const auto literal = [&] { return (1 + draw(variables)) * (draw(2) == 0 ? 1 : -1); };
    std::vector<Literal> assumptions;
    for (int question = 0; question < 60; ++question) {
      // Clauses come while questions go on.
      for (int i = 0; i < (question == 0 ? 45 : draw(2)); ++i) {
        Clause clause{literal(), literal(), literal()};
        maintenance.add(clause);
        solver.add(clause);
        clauses.push_back(std::move(clause));
      }
      // A few assumptions change from one question to the next.
      for (int i = draw(3); i >= 0 && !assumptions.empty(); --i) assumptions.erase(assumptions.begin());
      while (assumptions.size() < 5) assumptions.push_back(literal());
      const bool consistent = solver.solve(assumptions);
      switch (maintenance.ask(assumptions)) {
        case Answer::inconsistent: {
          EXPECT_FALSE(consistent);
          std::vector<Literal> blamed;
          std::copy_if(assumptions.begin(), assumptions.end(), std::back_inserter(blamed),
                       [&](Literal l) { return maintenance.failed(l); });
          EXPECT_FALSE(solver.solve(blamed)) << "what is blamed is a conflict by itself";
          continue;
        }
        case Answer::open:
          if (!consistent) continue;
          maintenance.adopt(assumptions, solver);
          break;
        case Answer::consistent:
          EXPECT_TRUE(consistent);
          break;
      }
      for (const Clause& clause : clauses) EXPECT_TRUE(satisfied(clause, maintenance));
      for (const Literal assumption : assumptions) EXPECT_TRUE(maintenance.value(assumption));
      for (Literal l = 1; l <= variables; ++l) {
        const Literal found = maintenance.value(l) ? l : -l;
        if (!maintenance.follows(found)) continue;
        std::vector<Literal> refuted = assumptions;
        refuted.push_back(-found);
        EXPECT_FALSE(solver.solve(refuted)) << "what follows is implied";
      }
    }
  }
}

TEST(TruthMaintenance, TakesAlongWhatRestedOnAnAssumption) {
  TruthMaintenance maintenance;
  const auto implies = [&](Literal a, Literal b) { maintenance.add(Clause{-a, b}); };
  implies(1, 2);
  implies(2, 3);
  implies(4, 3);
  ASSERT_EQ(maintenance.ask(Clause{1, 4}), Answer::consistent);
  EXPECT_TRUE(maintenance.follows(2));
  EXPECT_TRUE(maintenance.follows(3));
  ASSERT_EQ(maintenance.ask(Clause{4}), Answer::consistent);
  EXPECT_FALSE(maintenance.follows(2));
  EXPECT_TRUE(maintenance.follows(3)) << "by way of 4";
  ASSERT_EQ(maintenance.ask(Clause{1, -3}), Answer::inconsistent);
  EXPECT_TRUE(maintenance.failed(1));
  EXPECT_TRUE(maintenance.failed(-3));
  ASSERT_EQ(maintenance.ask(Clause{-3}), Answer::consistent);
  EXPECT_TRUE(maintenance.follows(-1));
}

TEST(TruthMaintenance, ClausesWithoutAModelRefuteEverything) {
  TruthMaintenance maintenance;
  maintenance.add(Clause{1});
  maintenance.add(Clause{-1});
  EXPECT_EQ(maintenance.ask(Clause{2}), Answer::inconsistent);
  EXPECT_FALSE(maintenance.failed(2));
  EXPECT_EQ(maintenance.ask(Clause{}), Answer::inconsistent);
}

}  // namespace
}  // namespace rmpl::automata
