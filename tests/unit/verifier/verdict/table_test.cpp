// Answers to a file of properties: counts, and JUnit XML that a reader of XML takes.
// SPDX-License-Identifier: MIT
#include "verifier/verdict/table.hpp"

#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "tests/unit/verifier/plants.hpp"
#include "verifier/check/check_all.hpp"

namespace rmpl::verifier {
namespace {

std::vector<Claim> claims(Slices& slices, const test::PlantBuilder& b, const Limits& limits) {
  const Property standby = Reachability{b.is("engine", "standby"), {}, false};
  const Property never_standby = Safety{b.is("engine", "standby"), {}, false};
  const std::vector<Question> questions = {{standby, {}}, {never_standby, {}}, {never_standby, {}}};
  const std::vector<Answer> answers = check_all(slices, questions, limits);
  return {{"can be <ready>", {"a/engine.props", 3, 1}, questions[0], false, answers[0]},
          {"never", {"a/engine.props", 7, 1}, questions[1], false, answers[1]},
          {"\"never\", expected not to", {}, questions[2], true, answers[2]}};
}

TEST(Table, CountsAgainstWhatIsExpected) {
  const auto b = test::engine();
  Slices slices(b.plant);
  const Count found = count(claims(slices, b, {}));
  EXPECT_EQ(found.expected, 2U);
  EXPECT_EQ(found.unexpected, 1U);
  EXPECT_EQ(found.undecided, 0U);
}

TEST(Table, JunitIsWellFormedAndCounts) {
  const auto b = test::engine();
  Slices slices(b.plant);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(to_junit({b.plant}, claims(slices, b, {})).c_str()));
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  EXPECT_EQ(suite.attribute("tests").as_int(), 3);
  EXPECT_EQ(suite.attribute("failures").as_int(), 1);
  EXPECT_EQ(suite.attribute("errors").as_int(), 0);
  EXPECT_EQ(std::distance(suite.begin(), suite.end()), 3);
  EXPECT_STREQ(suite.first_child().attribute("name").value(), "can be <ready>");
  EXPECT_FALSE(suite.first_child().child("failure"));
  const pugi::xml_node failure = suite.first_child().next_sibling().child("failure");
  EXPECT_STREQ(failure.attribute("message").value(), "violated");
  EXPECT_NE(std::string(failure.text().get()).find("engine: heating -> standby"), std::string::npos);
  EXPECT_NE(std::string(failure.text().get()).find("a/engine.props:7"), std::string::npos);
}

TEST(Table, PropertiesOfOneNameInTwoFilesAreTwo) {
  const auto b = test::engine();
  Slices slices(b.plant);
  std::vector<Claim> here = claims(slices, b, {}), there = here;
  for (Claim& claim : there) claim.origin.file = "b/engine.props";
  const auto identity = [&](const std::vector<Claim>& of) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(to_junit({b.plant}, of).c_str()));
    const pugi::xml_node suite = document.child("testsuites").child("testsuite");
    const pugi::xml_node first = suite.first_child();
    return std::vector<std::string>{suite.attribute("name").value(), first.attribute("classname").value(),
                                    first.attribute("file").value()};
  };
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NE(identity(here)[i], identity(there)[i]);
}

TEST(Table, WhatIsUndecidedIsAnErrorOfJunit) {
  const auto b = test::engine();
  Slices slices(b.plant);
  const std::atomic<bool> interrupted = true;
  Limits limits;
  limits.interrupted = &interrupted;
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(to_junit({b.plant}, claims(slices, b, limits)).c_str()));
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  EXPECT_EQ(suite.attribute("errors").as_int(), 3);
  EXPECT_TRUE(suite.first_child().child("error"));
}

}  // namespace
}  // namespace rmpl::verifier
