// How likely a target can become at most.
// SPDX-License-Identifier: MIT
#include "verifier/markov/prospects.hpp"

#include <gtest/gtest.h>

#include "tests/unit/verifier/plants.hpp"

namespace rmpl::verifier {
namespace {

using automata::ModeId;
using test::seconds;

/// A bolt that is fired, perhaps in vain, and then once more; until then time may break it. A pump beside it.
class ProspectsOfABolt : public testing::Test {
 protected:
  ProspectsOfABolt() {
    b_.control("cmd", {"none", "fire", "again"});
    auto& bolt = b_.component("bolt", {"holds", "gone", "jams!", "fails!"});
    b_.transition(bolt, 0, 1, b_.is("cmd", "fire"));
    b_.transition(bolt, 0, 2, b_.is("cmd", "fire"), {}, test::probability(0.01));
    b_.transition(bolt, 2, 1, b_.is("cmd", "again"));
    b_.transition(bolt, 2, 3, b_.is("cmd", "again"), {}, test::probability(0.01));
    b_.transition(bolt, 0, 3, automata::constant(true), {}, test::rate(1e-6));
    auto& pump = b_.component("pump", {"runs", "stands"});
    b_.transition(pump, 0, 1, b_.is("cmd", "fire"));
  }

  Prospects ask(const automata::Formula& target) {
    const Limits limits;
    Meter meter(limits);
    const std::vector<automata::Assignment> from;
    return Prospects(b_.plant, {target, false, Commands::any, from, seconds(1), 1000}, meter);
  }

  test::PlantBuilder b_;
};

TEST_F(ProspectsOfABolt, AreThoseOfWhatMayBeCommanded) {
  const Prospects prospects = ask(b_.is("bolt", "fails"));
  const Prospect holds = prospects.of({ModeId(0), ModeId(0)});
  EXPECT_NEAR(static_cast<double>(holds.once), 1e-4, 1e-6);
  EXPECT_NEAR(static_cast<double>(holds.each_step), 1e-6, 1e-8);
  const Prospect jams = prospects.of({ModeId(2), ModeId(1)});
  EXPECT_NEAR(static_cast<double>(jams.once), 1e-2, 1e-5);
  EXPECT_GE(static_cast<double>(holds.within(1000)), 1e-4 + 9.9e-4);
}

TEST_F(ProspectsOfABolt, AreNoneWhereNothingLeadsThere) {
  const Prospects prospects = ask(b_.is("bolt", "fails"));
  EXPECT_EQ(prospects.of({ModeId(1), ModeId(0)}).within(1'000'000), 0);
}

TEST_F(ProspectsOfABolt, AreCertainWhereItHoldsOrCanBeCommanded) {
  EXPECT_EQ(ask(b_.is("bolt", "fails")).of({ModeId(3), ModeId(0)}).within(0), 1);
  EXPECT_EQ(ask(b_.is("pump", "stands")).of({ModeId(0), ModeId(0)}).within(1), 1);
}

}  // namespace
}  // namespace rmpl::verifier
