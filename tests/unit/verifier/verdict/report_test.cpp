// Results as JSON and as text.
// SPDX-License-Identifier: MIT
#include "verifier/verdict/report.hpp"

#include <gtest/gtest.h>

#include "tests/unit/verifier/plants.hpp"
#include "verifier/check/check.hpp"

namespace rmpl::verifier {
namespace {

TEST(Report, TellsTheWitness) {
  const auto b = test::engine();
  Slices slices(b.plant);
  const Property property = Reachability{b.is("engine", "standby"), {}, false};
  const Answer result = check(slices, property, {}, {});
  const auto json = to_json(Subject{b.plant}, {property, {}}, result);
  EXPECT_EQ(json["property"], "reachability");
  EXPECT_EQ(json["verdict"], "holds");
  EXPECT_FALSE(json.contains("reason"));
  EXPECT_EQ(
      json["trace"].dump(),
      R"([{"time":0.0,"modes":{"engine":"off"},"command":{},"taken":{}},)"
      R"({"time":0.0,"modes":{"engine":"heating"},"command":{"cmd":"standby"},"taken":{"engine":{"from":"off","to":"heating"}}},)"
      R"({"time":30.0,"modes":{"engine":"standby"},"command":{},"taken":{"engine":{"from":"heating","to":"standby"}}}])");
  EXPECT_EQ(to_text({b.plant}, {property, {}}, result, false),
            "reachability: holds (the target is reachable)\n"
            "   0 s  the initial modes\n"
            "   0 s  command cmd = standby: engine: off -> heating\n"
            "  30 s  engine: heating -> standby\n");
}

TEST(Report, TellsWhatCutItShort) {
  const auto b = test::engine();
  Slices slices(b.plant);
  const Property property = Safety{b.is("engine", "failed"), {}, false};
  CheckOptions options;
  options.faults = 1;
  Limits limits;
  limits.states = 1;
  const Answer result = check(slices, property, options, limits);
  const auto json = to_json(Subject{b.plant}, {property, {}}, result);
  EXPECT_EQ(json["verdict"], "undecided");
  EXPECT_TRUE(json["trace"].empty());
  EXPECT_NE(json["reason"].get<std::string>().find("--max-states"), std::string::npos);
  EXPECT_EQ(json["statistics"]["states"], 1);
}

}  // namespace
}  // namespace rmpl::verifier
