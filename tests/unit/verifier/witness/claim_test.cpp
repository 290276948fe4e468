// A run that is possible, and does not show what it is said to show.
// SPDX-License-Identifier: MIT
#include "verifier/witness/claim.hpp"

#include <gtest/gtest.h>

#include "tests/unit/verifier/plants.hpp"

namespace rmpl::verifier {
namespace {

using automata::ModeId;
using automata::Ticks;
using automata::ValueId;
using test::seconds;

class ClaimEngine : public testing::Test {
 protected:
  std::optional<std::string> failure(const Property& property) {
    return failure_to_show(rules_, property, {}, witness_);
  }
  [[nodiscard]] automata::Formula is(const char* mode) const { return engine_.is("engine", mode); }

  test::PlantBuilder engine_ = test::engine();
  automata::PlainStep rules_{engine_.plant};
  /// off at 0, heating at 5 s, standby at 35 s.
  Witness witness_{{{Ticks{0}, {ModeId(0)}, {ValueId(0)}},
                    {seconds(5), {ModeId(1)}, {ValueId(1)}},
                    {seconds(35), {ModeId(2)}, {ValueId(0)}}},
                   std::nullopt,
                   std::nullopt};
};

TEST_F(ClaimEngine, TheTargetHoldsAtTheEndWithinTheWindow) {
  EXPECT_EQ(failure(Reachability{is("standby"), {}, false}), std::nullopt);
  EXPECT_EQ(failure(Safety{is("standby"), {}, false}), std::nullopt);
  EXPECT_TRUE(failure(Reachability{is("heating"), {}, false}));
  EXPECT_EQ(failure(Reachability{is("standby"), {std::nullopt, seconds(35)}, false}), std::nullopt);
  EXPECT_TRUE(failure(Reachability{is("standby"), {std::nullopt, seconds(34)}, false}));
  EXPECT_TRUE(failure(Reachability{is("standby"), {seconds(36), std::nullopt}, false}));
}

TEST_F(ClaimEngine, TheResponseHasNotComeInTime) {
  EXPECT_EQ(failure(Response{is("heating"), is("standby"), seconds(29)}), std::nullopt);
  EXPECT_TRUE(failure(Response{is("heating"), is("standby"), seconds(30)}));
  EXPECT_TRUE(failure(Response{is("firing"), is("standby"), seconds(1)}));
}

}  // namespace
}  // namespace rmpl::verifier
