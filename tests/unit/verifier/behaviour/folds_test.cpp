// Where a timer is told by its clock, and where by its mode.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/folds.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/unit/verifier/plants.hpp"

namespace rmpl::verifier {
namespace {

using automata::ComponentId;
using automata::ModeId;
using automata::Modes;
using test::PlantBuilder;
using test::within;

const ComponentId timer{0};
const std::vector<ComponentId> folded = {timer};

/// A timer that warns after 3 s and has run out after 5 s, and a reader that asks for it in its second mode alone.
PlantBuilder timer_and_reader() {
  PlantBuilder b;
  b.control("cmd", {"none", "go"});
  auto& t = b.component("timer", {"fresh", "warns", "old"});
  b.transition(t, 0, 1, automata::constant(true), within(3, 3));
  b.transition(t, 1, 2, automata::constant(true), within(2, 2));
  auto& reader = b.component("reader", {"sleeps", "looks", "rings"});
  b.transition(reader, 0, 1, b.is("cmd", "go"));
  b.transition(reader, 1, 2, b.is("timer", "old"));
  return b;
}

Modes modes(std::size_t timer_mode, std::size_t reader_mode) { return {ModeId(timer_mode), ModeId(reader_mode)}; }

class FoldsTest : public ::testing::Test {
 protected:
  explicit FoldsTest(PlantBuilder builder = timer_and_reader()) : plant_(std::move(builder.plant)) {}

  const automata::Plant plant_;
  automata::PlantStep step_{plant_};
  TimeModel time_ = TimeModel::dense(plant_, {});
  Folds folds_{step_, time_, Commands::one, {}};
};

TEST_F(FoldsTest, ATimerIsFoldedWhereNobodyAsks) {
  ASSERT_TRUE(folds_.any());
  EXPECT_EQ(folds_.in(modes(0, 0)), folded);
  EXPECT_EQ(folds_.in(modes(1, 0)), folded);
  EXPECT_TRUE(folds_.in(modes(2, 0)).empty()) << "nothing is left to come";
  EXPECT_TRUE(folds_.in(modes(0, 1)).empty()) << "the reader looks";
  EXPECT_EQ(folds_.in(modes(0, 2)), folded);
  EXPECT_EQ(folds_.limits(timer, ModeId(0))->upper, 5) << "the end of the chain counts";
  EXPECT_EQ(folds_.limits(timer, ModeId(2)), std::nullopt);
}

TEST_F(FoldsTest, WhatAQuestionReadsIsNotFolded) { EXPECT_FALSE(Folds(step_, time_, Commands::one, folded).any()); }

TEST(Folds, WhatAConstraintCanForbidIsNotFolded) {
  PlantBuilder b = timer_and_reader();
  b.plant.interconnections.emplace_back(
      automata::negation(automata::conjunction({b.is("timer", "old"), b.is("reader", "rings")})));
  automata::PlantStep step(b.plant);
  EXPECT_FALSE(Folds(step, TimeModel::dense(b.plant, {}), Commands::one, {}).any());
}

TEST(Folds, AChoiceOfTimesIsNotFolded) {
  PlantBuilder b;
  auto& t = b.component("timer", {"fresh", "old"});
  b.transition(t, 0, 1, automata::constant(true), within(3, 4));
  automata::PlantStep step(b.plant);
  EXPECT_FALSE(Folds(step, TimeModel::dense(b.plant, {}), Commands::one, {}).any());
}

TEST_F(FoldsTest, AZoneIsCutWhereTheReaderLooks) {
  Zone zone(1);
  zone.elapse();
  ASSERT_TRUE(zone.constrain(1, {1, 6}));
  std::vector<std::pair<std::size_t, Interval>> parts;  // by mode of the timer: what its clock reads
  folds_.unfold(modes(0, 1), 0, zone, folded, [&](const Modes& in, Zone&& part) {
    parts.emplace_back(in[0].index(), part.clocks() == 0 ? Interval{} : Interval{part.lower(1), part.upper(1)});
  });
  // At 3 s sharp it may be seen in either mode; the last one has no clock.
  const std::vector<std::pair<std::size_t, Interval>> expected = {{0, {1, 3}}, {1, {0, 2}}, {2, {}}};
  EXPECT_EQ(parts, expected);
}

TEST_F(FoldsTest, AZoneStaysWholeWhereNobodyLooks) {
  Zone zone(1);
  zone.elapse();
  std::size_t parts = 0;
  folds_.unfold(modes(0, 2), 0, zone, folded, [&](const Modes& in, Zone&& part) {
    EXPECT_EQ(in, modes(0, 2));
    EXPECT_EQ(part, zone);
    ++parts;
  });
  EXPECT_EQ(parts, 1u);
}

TEST_F(FoldsTest, WhatIsDueAtAnInstantHasMovedOn) {
  Zone zone(1);
  zone.elapse();
  ASSERT_TRUE(zone.constrain(1, {2, 3}));
  EXPECT_EQ(folds_.asked_of(modes(0, 1), modes(0, 0), 0, zone), timer);
  EXPECT_EQ(folds_.asked_of(modes(0, 2), modes(0, 0), 0, zone), std::nullopt);
  std::vector<std::size_t> parts;
  folds_.cut(modes(0, 0), 0, zone, timer, [&](const Modes& in, Zone&& part) {
    parts.push_back(in[0].index());
    EXPECT_EQ(part.upper(1), in[0].index() == 0 ? 2 : 0);
  });
  EXPECT_EQ(parts, (std::vector<std::size_t>{0, 1}));
}

}  // namespace
}  // namespace rmpl::verifier
