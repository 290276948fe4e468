// Steps of model programs, by hand: what the paper and semantics 8 say of each construct.
// SPDX-License-Identifier: MIT
#include "automata/step/marking_step.hpp"

#include <gmock/gmock.h>

#include <map>

namespace rmpl::automata {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

class Steps : public ::testing::Test {
 protected:
  Steps() {
    program_.variables.add({"x", {"a", "b"}});
    program_.controls.push_back({x_, std::nullopt});
    composite(std::nullopt);
  }

  LocationId composite(std::optional<std::size_t> parent, bool start = true) {
    const LocationId self(program_.locations.size());
    ModelLocation& location = program_.locations.emplace_back();
    location.composite = true;
    if (parent) location.parent = LocationId(*parent);
    location.start = parent && start;
    return self;
  }
  /// A location with one function.
  LocationId primitive(std::size_t parent, bool start, std::vector<std::size_t> targets,
                       Formula told = constant(true)) {
    const LocationId self(program_.locations.size());
    ModelLocation& location = program_.locations.emplace_back();
    location.parent = LocationId(parent);
    location.start = start;
    location.told = std::move(told);
    TransitionFunction& function = location.functions.emplace_back();
    for (const std::size_t target : targets) function.arcs.push_back({{}, LocationId(target)});
    return self;
  }
  [[nodiscard]] Formula x_is(std::size_t value) const { return is(x_, ValueId(value)); }

  /// Where the start leads in one step, as printed.
  std::map<std::vector<std::size_t>, double> step(const Command& command = {std::nullopt}) {
    MarkingStep step(program_);
    step.command(command);
    std::map<std::vector<std::size_t>, double> result;
    const auto initial = step.initial();
    for (const auto& start : *initial) {
      const auto& ways = step.ways(start.target);
      for (const auto& way : *ways) {
        std::vector<std::size_t> numbers;
        for (const LocationId l : step.whole(way.target)) numbers.push_back(l.index() + 1);
        result[numbers] += start.probability * way.probability;
      }
    }
    return result;
  }

  const VariableId x_{0};
  ModelProgram program_;
};

/// `choose { A with 1 }` under `always` takes A's arcs in the instant of the draw: 2 always, 3 choose, 4 and 5 are A.
TEST_F(Steps, AChoiceOfOneIsThatOne) {
  primitive(0, true, {1, 2});
  const LocationId choice = primitive(0, true, {});
  const LocationId next = primitive(0, false, {4});
  primitive(0, false, {}, x_is(0));
  program_.locations[choice.index()].functions = {{1, {next}, {}}};
  EXPECT_THAT(step(), ElementsAre(Pair(ElementsAre(1, 2, 3, 5), 1.0)));
}

/// What is told in the instant in which the condition is entailed still counts, and then the composite ends.
TEST_F(Steps, WatchingIsWeak) {
  const LocationId watched = composite(0);
  primitive(1, true, {2}, x_is(0));
  primitive(0, false, {});
  program_.locations[watched.index()].maintenance = {false, x_is(0)};
  program_.locations[watched.index()].arcs = {{{}, LocationId(3)}};
  EXPECT_THAT(step(), ElementsAre(Pair(ElementsAre(1, 4), 1.0)));
}

/// Two threads inside, each with a coin: the composite ends where both end.
TEST_F(Steps, ACompositeEndsWhenAllInsideDoes) {
  const LocationId both = composite(0);
  const LocationId first = primitive(1, true, {2});
  const LocationId second = primitive(1, true, {3});
  primitive(0, false, {});
  program_.locations[both.index()].arcs = {{{}, LocationId(4)}};
  for (const LocationId l : {first, second}) {
    program_.locations[l.index()].functions.front().probability = 0.5;
    program_.locations[l.index()].functions.push_back({0.5, {}, {}});
  }
  EXPECT_THAT(step(), ElementsAre(Pair(ElementsAre(1, 2, 3), 0.25), Pair(ElementsAre(1, 2, 3, 4), 0.25),
                                  Pair(ElementsAre(1, 2, 4), 0.25), Pair(ElementsAre(1, 5), 0.25)));
}

/// A command is in the store of the step, and in no other; one that contradicts what is told leaves no step.
TEST_F(Steps, CommandsCountInTheStep) {
  const LocationId asks = primitive(0, true, {});
  primitive(0, false, {}, x_is(1));
  program_.locations[asks.index()].functions.front().arcs = {{{{true, x_is(0)}}, LocationId(2)}};
  EXPECT_THAT(step({ValueId(0)}), ElementsAre(Pair(ElementsAre(1, 3), 1.0)));
  EXPECT_THAT(step({std::nullopt}), ElementsAre(Pair(ElementsAre(), 1.0)));
  program_.locations[asks.index()].told = x_is(1);
  EXPECT_THAT(step({ValueId(0)}), ElementsAre());
}

/// Before time 0 a choice has been made; inconsistent starts are dropped.
TEST_F(Steps, TheStartIsDrawn) {
  const LocationId choice = primitive(0, false, {});
  const LocationId a = primitive(0, false, {2}, x_is(0));
  const LocationId b = primitive(0, false, {3}, x_is(1));
  program_.initial.push_back({choice, {{0.75, {a}}, {0.25, {b}}}});
  EXPECT_THAT(step(), ElementsAre(Pair(ElementsAre(1, 3), 0.75), Pair(ElementsAre(1, 4), 0.25)));
  program_.constraints.emplace_back(x_is(1));
  EXPECT_THAT(step(), ElementsAre(Pair(ElementsAre(1, 4), 0.25)));
}

}  // namespace
}  // namespace rmpl::automata
