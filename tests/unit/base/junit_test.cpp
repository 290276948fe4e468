// JUnit XML: what is written is read.
// SPDX-License-Identifier: MIT
#include "base/junit.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace rmpl::base {
namespace {

TEST(Junit, ReadsWhatItWrites) {
  using Outcome = TestCase::Outcome;
  const std::vector<TestSuite> suites = {
      {"first", {{"a < b", "of", 0.5, Outcome::success, "", "", "noted\n", "x.scn", 7, {"R-1", "R \"2\""}}}},
      {"second",
       {{"c", "of", 0, Outcome::failure, "why", "text\n"},
        {"d", "of", 0, Outcome::error, "how", "text\n"},
        {"e", "of", 0, Outcome::skipped, "not", ""}}}};
  const std::vector<TestSuite> read = read_junit(to_junit(suites));
  EXPECT_EQ(to_junit(read), to_junit(suites));
  ASSERT_EQ(read.size(), 2);
  EXPECT_EQ(read[0].cases[0].name, "a < b");
  EXPECT_EQ(read[0].cases[0].notes, "noted\n");
  EXPECT_EQ(read[0].cases[0].line, 7);
  EXPECT_EQ(read[0].cases[0].requirements, (std::vector<std::string>{"R-1", "R \"2\""}));
  EXPECT_EQ(read[1].cases[1].outcome, Outcome::error);
  EXPECT_EQ(read[1].cases[2].message, "not");
}

TEST(Junit, RefusesWhatIsNone) {
  EXPECT_THROW(read_junit(""), InputError);
  EXPECT_THROW(read_junit("<a/>"), InputError);
  EXPECT_THROW(read_junit("<testsuites>"), InputError);
}

}  // namespace
}  // namespace rmpl::base
