// The share of outcomes that can happen beside a sum over all of them.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/possible_share.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace rmpl::runtime {
namespace {

using automata::ModeId;
using automata::Modes;
using automata::Move;
using automata::ValueId;
using automata::VariableId;

/// A ring of links, no two of which in a row may be silent together.
class Ring : public testing::Test {
 protected:
  static constexpr std::size_t size = 9;

  Ring() {
    std::vector<VariableId> outs;
    for (std::size_t c = 0; c < size; ++c) {
      const std::string name = "link" + std::to_string(c);
      const VariableId out = plant.variables.add({name + ".out", {"no", "yes"}});
      const VariableId variable = plant.variables.add({name, {"up", "down", "dead"}});
      automata::Component link{name, "Link", variable, {}, {1, 0, 0}, {}, {}};
      link.modes = {{"up", false, automata::is(out, ValueId(1)), 0, {}},
                    {"down", true, automata::is(out, ValueId(0)), 0, {}},
                    {"dead", true, automata::is(out, ValueId(0)), 0, {}}};
      plant.components.push_back(std::move(link));
      outs.push_back(out);
    }
    for (std::size_t c = 0; c < size; ++c) {
      const std::vector<automata::Formula> both{automata::is(outs[c], ValueId(0)),
                                                automata::is(outs[(c + 1) % size], ValueId(0))};
      plant.interconnections.emplace_back(automata::negation(automata::conjunction(both)));
    }
  }

  /// Over all outcomes.
  double sum(automata::PlantStep& step) const {
    double result = 0;
    Modes modes(size);
    std::vector<std::size_t> place(size, 0);
    for (;;) {
      double product = 1;
      for (std::size_t c = 0; c < size; ++c) {
        modes[c] = moves[c][place[c]].mode;
        product *= moves[c][place[c]].probability;
      }
      if (step.possible(modes)) result += product;
      std::size_t c = size;
      while (c > 0 && ++place[c - 1] == moves[c - 1].size()) place[--c] = 0;
      if (c == 0) return result;
    }
  }

  void expect_the_sum() {
    automata::PlantStep step(plant);
    PossibleShare shares(step);
    const auto share =
        shares.of(Modes(size), [&](std::size_t component) { return std::span<const Move>(moves[component]); });
    EXPECT_TRUE(share.exact);
    const double all = sum(step);
    EXPECT_NEAR(share.value, all, 1e-13 * all);
  }

  automata::Plant plant;
  std::vector<std::vector<Move>> moves;
};

TEST_F(Ring, RareOutcomesThatArePassedOverWeighNothing) {
  for (std::size_t c = 0; c < size; ++c) {
    const double down = std::pow(10.0, -1 - static_cast<int>(c % 5)),
                 dead = std::pow(10.0, -6 - static_cast<int>(c % 4));
    moves.push_back({{ModeId(0), 1 - down - dead}, {ModeId(1), down}, {ModeId(2), dead}});
  }
  expect_the_sum();
}

TEST_F(Ring, LittleThatIsPossibleIsSummedWhole) {
  for (std::size_t c = 0; c < size; ++c) {
    const double up = c < 2 ? 1e-9 : 0.999;
    moves.push_back({{ModeId(0), up}, {ModeId(1), 1 - up - 1e-10}, {ModeId(2), 1e-10}});
  }
  expect_the_sum();
}

}  // namespace
}  // namespace rmpl::runtime
