// Decisions against a list of all reasons.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/decisions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace rmpl::verifier {
namespace {

using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::ValueId;

/// Some premises of four, all of which decide the answer: the first of them that is not 0.
TEST(Decisions, AnswersAsTheReasonsDo) {
  std::mt19937 random(1);
  const auto draw = [&](std::uint32_t most) { return std::uniform_int_distribution<std::uint32_t>(0, most)(random); };
  Decisions decisions;
  std::size_t known = 0;
  for (int round = 0; round < 500; ++round) {
    const Modes modes = {ModeId(draw(2)), ModeId(draw(2))};
    const ControlAction action = {ValueId(draw(3)), ValueId(draw(1))};
    const std::vector<Premise> all = {
        {2, action[0].value}, {0, modes[0].value}, {3, action[1].value}, {1, modes[1].value}};
    const auto decided = std::find_if(all.begin(), all.end(), [](const Premise& p) { return p.value != 0; });
    const auto end = decided == all.end() ? decided : decided + 1;
    const std::uint32_t answer = decided == all.end() ? 99 : 10 * decided->position + decided->value;
    if (const auto found = decisions.find(modes, action)) {
      ++known;
      EXPECT_EQ(*found, answer);
    } else {
      decisions.add(modes, action, std::vector<Premise>(all.begin(), end), answer);
      EXPECT_EQ(decisions.find(modes, action), answer);
    }
  }
  EXPECT_GT(known, 450u);
}

TEST(Decisions, NothingToAskForIsOneAnswer) {
  Decisions decisions;
  EXPECT_FALSE(decisions.find({}, {}));
  decisions.add({}, {}, {}, 7);
  EXPECT_EQ(decisions.find({ModeId(1)}, {ValueId(2)}), 7u);
}

}  // namespace
}  // namespace rmpl::verifier
