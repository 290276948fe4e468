// What searches look things up in, beside looking at all of them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/engineered.hpp"
#include "tests/property/generate.hpp"
#include "verifier/behaviour/reasons.hpp"
#include "verifier/cut_set/fault_sets.hpp"
#include "verifier/search/bounding_forest.hpp"

namespace rmpl::property {
namespace {

using verifier::Fault;
using verifier::Units;

/// Wherever the premises of a reason hold, the component may do the same.
RC_GTEST_PROP(Lookup, AReasonIsEnough, ()) {
  const automata::Plant plant = (*engineered()).plant;
  automata::PlantStep step(plant);
  for (int question = 0; question < 3; ++question) {
    const automata::Modes modes = *modes_of(plant);
    const automata::ControlAction action = *actions_of(plant);
    if (!step.consistent(modes, action)) continue;
    const automata::ComponentId component(up_to(0, modes.size() - 1));
    std::vector<automata::ComponentId> unknown;
    if (const automata::ComponentId other(up_to(0, modes.size() - 1)); other != component && up_to(0, 1) == 0) {
      unknown.push_back(other);
    }
    const auto why = verifier::reason(step, component, modes, action, unknown);
    if (!why) continue;
    const automata::Enabled expected = step.enabled(component, modes, action);
    for (int draw = 0; draw < 6; ++draw) {
      automata::Modes others = *modes_of(plant);
      automata::ControlAction command = *actions_of(plant);
      others[component.index()] = modes[component.index()];
      for (const verifier::Premise& premise : *why) {
        const bool is_mode = premise.position < modes.size();
        if (is_mode) RC_ASSERT(modes[premise.position].value == premise.value);
        if (is_mode) others[premise.position] = modes[premise.position];
        if (!is_mode) command[premise.position - modes.size()] = action[premise.position - modes.size()];
      }
      if (!step.consistent(others, command)) continue;
      const automata::Enabled& found = step.enabled(component, others, command);
      RC_ASSERT(found.untimed == expected.untimed && found.timed == expected.timed);
      RC_ASSERT(found.faults == expected.faults);
    }
  }
}

/// Bounds of zones: a chain of intervals that grow, as clocks of a component that starts anew again and again have, or
/// anything.
std::vector<std::vector<Units>> draw_rows(std::size_t width) {
  const auto count = *rc::gen::inRange<std::size_t>(0, 400);
  const bool chain = *rc::gen::arbitrary<bool>();
  std::vector<std::vector<Units>> rows;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<Units> row;
    for (std::size_t e = 0; e < width; ++e) {
      const Units step = *rc::gen::inRange<Units>(-3, 4);
      const bool open = *rc::gen::inRange(0, 20) == 0;
      row.push_back(open ? verifier::unbounded : chain ? static_cast<Units>(i) * (e % 2 == 0 ? 1 : -1) + step : step);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

bool no_less(const Units* a, const Units* b, std::size_t width) {
  return std::equal(a, a + width, b, std::greater_equal<>());
}

RC_GTEST_PROP(Lookup, TheForestHidesNoneThatIsAboveOrBelow, ()) {
  const auto width = *rc::gen::inRange<std::size_t>(1, 6);
  const std::vector<std::vector<Units>> rows = draw_rows(width);
  std::vector<bool> gone(rows.size());
  verifier::BoundingForest forest(width);
  const auto row_of = [&](std::uint32_t item, std::span<Units> row) {
    std::copy(rows[item].begin(), rows[item].end(), row.begin());
    return !gone[item];
  };
  std::size_t shown_in_all = 0;
  for (std::uint32_t added = 0; added < rows.size(); ++added) {
    forest.add(added, row_of);
    if (*rc::gen::inRange(0, 10) == 0) gone[*rc::gen::inRange<std::size_t>(0, added + 1)] = true;
    const std::vector<Units>& asked = rows[*rc::gen::inRange<std::size_t>(0, rows.size())];
    for (const bool above : {true, false}) {
      std::set<std::uint32_t> expected, found;
      const auto suits = [&](const Units* row) {
        return above ? no_less(row, asked.data(), width) : no_less(asked.data(), row, width);
      };
      for (std::uint32_t i = 0; i <= added; ++i) {
        if (!gone[i] && suits(rows[i].data())) expected.insert(i);
      }
      const auto show = [&](std::uint32_t item) {
        ++shown_in_all;
        if (!gone[item] && suits(rows[item].data())) RC_ASSERT(found.insert(item).second);
        return false;
      };
      RC_ASSERT(!(above ? forest.above(suits, show) : forest.below(suits, show)));
      RC_ASSERT(found == expected);
    }
  }
}

/// A chain of intervals that each begin and end a little later, as a reboot that is due again and again makes: a
/// question looks at a few of them, however many there are.
TEST(Lookup, AQuestionLooksAtFewOfMany) {
  constexpr std::uint32_t many = 100'000;
  verifier::BoundingForest forest(2);
  const auto row_of = [](std::uint32_t item, std::span<Units> row) {
    row[0] = 40 * Units{item};
    row[1] = -30 * Units{item};
    return true;
  };
  for (std::uint32_t i = 0; i < many; ++i) forest.add(i, row_of);
  std::size_t branches = 0, shown = 0;
  const auto may = [&](const Units* corner) {
    ++branches;
    return corner[0] >= 40 * Units{many} / 2 && corner[1] >= -30 * Units{many} / 2;
  };
  EXPECT_FALSE(forest.above(may, [&](std::uint32_t) {
    ++shown;
    return false;
  }));
  EXPECT_LT(branches, 200u);
  EXPECT_LT(shown, 100u);
}

std::vector<Fault> draw_faults() {
  std::set<Fault> faults;
  const int count = *rc::gen::inRange(0, 5);
  for (int i = 0; i < count; ++i) {
    faults.insert({automata::ComponentId(*rc::gen::inRange<std::size_t>(0, 6)),
                   automata::ModeId(*rc::gen::inRange<std::size_t>(1, 3))});
  }
  return {faults.begin(), faults.end()};
}

RC_GTEST_PROP(Lookup, TheTreeOfSetsKnowsSubsets, ()) {
  verifier::FaultSetTree tree;
  std::vector<std::vector<Fault>> sets;
  const int count = *rc::gen::inRange(0, 40);
  for (int i = 0; i < count; ++i) {
    sets.push_back(draw_faults());
    tree.add(sets.back());
    const std::vector<Fault> asked = draw_faults();
    bool some = false, proper = false;
    for (const std::vector<Fault>& set : sets) {
      const bool within = std::includes(asked.begin(), asked.end(), set.begin(), set.end());
      some = some || within;
      proper = proper || (within && set != asked);
    }
    RC_ASSERT(tree.holds_subset_of(asked) == some);
    RC_ASSERT(tree.holds_proper_subset_of(asked) == proper);
  }
}

}  // namespace
}  // namespace rmpl::property
