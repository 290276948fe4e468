// Cells of program clocks.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/clock_cells.hpp"

#include <gtest/gtest.h>

#include <array>

namespace rmpl::verifier {
namespace {

using automata::ClockId;
using automata::Comparison;
using automata::Location;
using automata::LocationId;
using automata::Ticks;

/// Waits for x >= 5 s, then for y > 3 s; nothing is read after that.
automata::Program program() {
  automata::Program result;
  result.clocks = {"x", "y"};
  result.locations.resize(4);
  result.locations[0].composite = true;
  for (std::size_t l = 1; l < 4; ++l) result.locations[l].parent = LocationId(0);
  result.locations[1].start = true;
  result.locations[1].arcs = {
      {{true, automata::clock_bound(ClockId(0), Comparison::at_least, Ticks::of_seconds(5))}, LocationId(2)}};
  result.locations[2].arcs = {
      {{true, automata::clock_bound(ClockId(1), Comparison::greater, Ticks::of_seconds(3))}, LocationId(3)}};
  return result;
}

const std::array x = {ClockId(0)};
const std::array y = {ClockId(1)};
const std::array both = {ClockId(0), ClockId(1)};

TEST(ClockCells, ShareOneScale) {
  const ClockCells cells(program());
  EXPECT_EQ(cells.constants(), (std::vector<Ticks>{Ticks::of_seconds(3), Ticks::of_seconds(5)}));
  EXPECT_EQ(cells.around(x, 0), (Cell{0, 2}));
  EXPECT_EQ(cells.around(x, 4), (Cell{3, 4}));
  EXPECT_EQ(cells.around(y, 0), (Cell{0, 1}));
  EXPECT_EQ(cells.around(both, 2), (Cell{2, 2}));
  EXPECT_TRUE(cells.is_last(cells.around(y, 2)));
}

TEST(ClockCells, AreClosedInDenseTimeAndExactInSampledTime) {
  const ClockCells cells(program());
  const TimeModel dense = TimeModel::dense({}, cells.constants());
  EXPECT_EQ(cells.units({0, 2}, dense), (Interval{0, 5}));
  EXPECT_EQ(cells.units({3, 4}, dense), (Interval{5, unbounded}));
  const TimeModel sampled = TimeModel::sampled(Ticks::of_seconds(1));
  EXPECT_EQ(cells.units({0, 2}, sampled), (Interval{1, 4}));  // it is never read at 0
  EXPECT_EQ(cells.units({3, 4}, sampled), (Interval{5, unbounded}));
  EXPECT_EQ(cells.units({2, 4}, sampled), (Interval{4, unbounded}));  // y > 3 s
  EXPECT_TRUE(cells.units({1, 1}, TimeModel::sampled(Ticks::of_seconds(2))).empty());
}

TEST(ClockCells, ReadTheNearest) {
  const ClockCells cells(program());
  EXPECT_EQ(cells.nearest({0, 2}, Ticks::of_seconds(5)), Ticks::of_seconds(5) - Ticks{1});
  EXPECT_EQ(cells.nearest({0, 2}, Ticks{0}), Ticks{1});
  EXPECT_EQ(cells.nearest({3, 4}, Ticks::of_seconds(5)), Ticks::of_seconds(5));
  EXPECT_EQ(cells.nearest({3, 4}, Ticks::of_seconds(9)), Ticks::of_seconds(9));
}

TEST(ClockCells, AnEarlierClockIsAhead) {
  const ClockCells cells(program());
  EXPECT_TRUE(cells.in_order({3, 4}, {0, 2}));
  EXPECT_TRUE(cells.in_order({2, 2}, {2, 2}));
  EXPECT_FALSE(cells.in_order({0, 2}, {3, 4}));
  EXPECT_FALSE(cells.in_order({3, 3}, {3, 3}));
}

TEST(ClockCells, LiveWhileTheyMayBeRead) {
  const ClockCells cells(program());
  EXPECT_EQ(cells.live({LocationId(1)}), (std::vector<bool>{true, true}));
  EXPECT_EQ(cells.live({LocationId(2)}), (std::vector<bool>{false, true}));
  EXPECT_EQ(cells.live({LocationId(3)}), (std::vector<bool>{false, false}));
}

}  // namespace
}  // namespace rmpl::verifier
