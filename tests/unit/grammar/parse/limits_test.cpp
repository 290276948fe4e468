// What no person writes: deep nesting, large texts, bytes that are no text.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/unit/grammar/parse/trees.hpp"

namespace rmpl::grammar {
namespace {

using test::Parsed;

std::string times(std::size_t count, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

/// Texts that nest `n` deep, one for each way to do so.
std::vector<std::string> deep_constraints(std::size_t n) {
  return {times(n, "(") + "a = b" + times(n, ")"),
          times(n, "!") + "a = b",
          times(n / 2, "!(") + "a = b" + times(n / 2, ")"),
          times(n, "a = b -> ") + "a = b",
          times(n, "a = b <-> ") + "a = b",
          times(n / 2, "(a = b -> ") + "a = b" + times(n / 2, ")")};
}

std::vector<std::string> deep_programs(std::size_t n) {
  std::vector<std::string> programs = {times(n, "do ") + "a = b" + times(n, " watching c = d"),
                                       times(n, "always ") + "a = b",
                                       times(n, "next ") + "a = b",
                                       times(n, "when a = b donext ") + "a = b",
                                       times(n, "if a = b thennext ") + "a = b" + times(n, " elsenext a = b"),
                                       times(n, "{") + "a = b" + times(n, "}"),
                                       times(n / 2, "when a = b donext {") + "a = b" + times(n / 2, "}"),
                                       "a = b" + times(n, " maintaining c = d"),
                                       times(n / 2, "do ") + "a = b" + times(n / 2, " maintaining c = d"),
                                       times(n, "choose { ") + "a = b" + times(n, " with 0.5 }")};
  for (std::string& program : programs) program = "M() :: { " + program + " }";
  return programs;
}

TEST(Limits, ReasonableNestingParses) {
  for (const std::string& text : deep_constraints(nesting_limit - 10))
    EXPECT_TRUE(Parsed<Constraint>(parse_constraint, text).tree) << text;
  for (const std::string& text : deep_programs(nesting_limit / 2 - 10))
    EXPECT_TRUE(Parsed<ProgramFile>(parse_program, text).tree) << text;
}

TEST(Limits, DeepNestingIsOneError) {
  for (const std::string& text : deep_constraints(10'000)) {
    const Parsed<Constraint> result(parse_constraint, text);
    ASSERT_EQ(result.diagnostics.all().size(), 1u) << result.errors();
    EXPECT_EQ(result.diagnostics.all()[0].code, Code::nesting_too_deep);
  }
  for (const std::string& text : deep_programs(10'000)) {
    const Parsed<ProgramFile> result(parse_program, text);
    ASSERT_EQ(result.diagnostics.all().size(), 1u) << result.errors();
    EXPECT_EQ(result.diagnostics.all()[0].code, Code::nesting_too_deep);
  }
}

TEST(Limits, FlatTextsMayBeLong) {
  const Parsed<Constraint> wide(parse_constraint, times(100'000, "a = b | ") + "a = b");
  ASSERT_TRUE(wide.tree);
  EXPECT_EQ(std::get<Disjunction>(wide.tree->node).operands.size(), 100'001u);
  EXPECT_TRUE(
      Parsed<ProgramFile>(parse_program, "M() :: { " + times(50'000, "when a = b donext { c = d };") + " }").tree);
}

TEST(Limits, NulAndWrongUtf8AreErrorsInTheirPlace) {
  const Parsed<Constraint> result(parse_constraint, std::string("a = b &\n \xff\xfe c\0 = d", 18));
  EXPECT_FALSE(result.tree);
  EXPECT_EQ(
      result.errors(),
      "2:2 byte 0xFF is not UTF-8: text in UTF-8 was expected\n2:6 NUL byte in the text: UTF-8 text was expected\n");
}

TEST(Limits, AByteOrderMarkIsSkipped) { EXPECT_TRUE(Parsed<Constraint>(parse_constraint, "\xEF\xBB\xBF a = b").tree); }

TEST(Limits, NumbersBeyondTheirRangeAreErrors) {
  const Parsed<PlantFile> plant(parse_plant, "component C { any -> a with 1e999; any -> b with 1e-999; }");
  EXPECT_EQ(plant.errors(), "1:29 number out of range: at most 1.8e308\n");
  const Parsed<ScenarioFile> scenario(parse_scenarios, "scenario \"s\" { seed 18446744073709551616; }");
  EXPECT_EQ(scenario.errors(), "1:21 number out of range: a whole number below 2^64 was expected\n");
}

}  // namespace
}  // namespace rmpl::grammar
