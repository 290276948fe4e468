// What goes with a declaration that is taken out, and what stays.
// SPDX-License-Identifier: MIT
#include "compiler/lint/removal.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rmpl::compiler {
namespace {

/// The text without the statement, or the name, that begins at `|`; "-" where it is not taken out.
template <class Take>
std::string without(std::string text, const Take& take) {
  const auto at = static_cast<std::uint32_t>(text.find('|'));
  text.erase(at, 1);
  grammar::Sources sources;
  sources.add("a", text);
  Removals removals(sources);
  const auto edits = take(removals, grammar::Span{0, at, at + 1});
  if (edits.empty()) return "-";
  EXPECT_EQ(edits.size(), 1);
  return text.erase(edits[0].span.begin, edits[0].span.end - edits[0].span.begin);
}

std::string without_statement(const std::string& text) {
  return without(text, [](Removals& removals, grammar::Span span) { return removals.of_statement(span); });
}

std::string without_name(const std::string& text) {
  return without(text, [](Removals& removals, grammar::Span span) { return removals.of_name(span); });
}

TEST(Removals, TakeWholeLines) {
  EXPECT_EQ(without_statement("a;\n  b |c\n  d;\ne;\n"), "a;\ne;\n");
  EXPECT_EQ(without_statement("{\n  |b;\n}\n"), "{\n}\n");
  EXPECT_EQ(without_statement("|b;"), "");
  EXPECT_EQ(without_statement("a;\n|b;  \n"), "a;\n");
}

TEST(Removals, LeaveOneBlankLine) {
  EXPECT_EQ(without_statement("a;\n\n|b;\n\nc;\n"), "a;\n\nc;\n");
  EXPECT_EQ(without_statement("a;\n\n|b;\nc;\n"), "a;\n\nc;\n");
  EXPECT_EQ(without_statement("a;\n|b;\n\nc;\n"), "a;\n\nc;\n");
  EXPECT_EQ(without_statement("|b;\n\nc;\n"), "c;\n");
  EXPECT_EQ(without_statement("{\n  |b;\n\n  c;\n}"), "{\n  c;\n}");
  EXPECT_EQ(without_statement("{\n  a;\n\n  |b;\n}"), "{\n  a;\n}");
  EXPECT_EQ(without_statement("a;\n\n|b;\n\n// of c\nc;\n"), "a;\n\n// of c\nc;\n");
}

TEST(Removals, LeaveWhatElseStandsOnTheLine) {
  EXPECT_EQ(without_statement("a; |b; c;"), "a; c;");
  EXPECT_EQ(without_statement("|b; c;"), "c;");
  EXPECT_EQ(without_statement("a;\n  |b; c;"), "a;\n  c;");
  EXPECT_EQ(without_statement("{ |b; }"), "{ }");
}

TEST(Removals, TakeAllowancesAndNoOtherComments) {
  EXPECT_EQ(without_statement("a;\n// lint: x\n/* lint: y */\n|b;  // lint: z\nc;"), "a;\nc;");
  EXPECT_EQ(without_statement("a;\n// of b\n|b;"), "-");
  EXPECT_EQ(without_statement("a;\n// of b\n// lint: x\n|b;"), "-");
  EXPECT_EQ(without_statement("a;\n// of all\n\n|b;\nc;"), "a;\n// of all\n\nc;");
  EXPECT_EQ(without_statement("a;  // of a\n|b;\nc;"), "a;  // of a\nc;");
  EXPECT_EQ(without_statement("a;\n|b;  // of b\n"), "-");
  EXPECT_EQ(without_statement("a;\n|b /* of b */ c;\n"), "-");
  EXPECT_EQ(without_statement("a;\n/* of b */ |b;\n"), "-");
  EXPECT_EQ(without_statement("a;\n|b;\n// of c\nc;"), "a;\n// of c\nc;");
  // The allowance speaks of what else stands there, too.
  EXPECT_EQ(without_statement("// lint: x\n|b; c;"), "// lint: x\nc;");
}

TEST(Removals, TakeANameOutOfItsList) {
  EXPECT_EQ(without_name("clock |a, b, c;"), "clock b, c;");
  EXPECT_EQ(without_name("clock a, |b, c;"), "clock a, c;");
  EXPECT_EQ(without_name("clock a, b, |c;"), "clock a, b;");
  EXPECT_EQ(without_name("clock a,\n      |b,\n      c;"), "clock a,\n      c;");
  EXPECT_EQ(without_name("x;\nclock |a;\ny;"), "x;\ny;");
  EXPECT_EQ(without_name("clock a, /* of b */ |b;"), "-");
  EXPECT_EQ(without_name("clock |a, // of a\n b;"), "-");
}

}  // namespace
}  // namespace rmpl::compiler
