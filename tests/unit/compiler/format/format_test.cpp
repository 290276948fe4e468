// The one style: what is kept, what is settled, and what it costs.
// SPDX-License-Identifier: MIT
#include "compiler/format/format.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "compiler/format/difference.hpp"
#include "tests/paths.hpp"

namespace rmpl::compiler {
namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Format, EveryExampleIsFormattedAndThenSettled) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(paths::source() + "/examples")) {
    const auto kind = kind_by_name(entry.path().string());
    if (!entry.is_regular_file() || !kind || *kind == Kind::document) continue;
    const auto once = format(read(entry.path()), *kind);
    ASSERT_TRUE(once) << entry.path();
    EXPECT_EQ(format(*once, *kind), once) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 20u);
}

TEST(Format, ATextWithErrorsHasNone) {
  EXPECT_EQ(format("A() :: { x = }", Kind::program), std::nullopt);
  EXPECT_EQ(format("/* not closed", Kind::plant), std::nullopt);
}

TEST(Format, AnEmptyTextStaysEmpty) {
  EXPECT_EQ(format("", Kind::scenario), "");
  EXPECT_EQ(format(" \n\t\n", Kind::properties), "");
  EXPECT_EQ(format("\n\n// only this", Kind::plant), "// only this\n");
}

TEST(Format, LinesEndWithALineFeed) {
  EXPECT_EQ(format("\xEF\xBB\xBF// one  \r\nfaults 1;\r\n\r\n\r\ntime dense;", Kind::properties),
            "// one\nfaults 1;\n\ntime dense;\n");
}

TEST(Format, ACommentBehindADivisionStaysOne) {
  EXPECT_EQ(format("component A { mode a; a -> a with rate 1 / /* per */ h; }", Kind::plant),
            "component A {\n  mode a;\n  a -> a with rate 1 / /* per */ h;\n}\n");
}

TEST(Format, TheLinesOfACommentMoveTogether) {
  EXPECT_EQ(format("component A {\n      /* one\n           two\n   three */\n  mode a;\n}", Kind::plant),
            "component A {\n  /* one\n       two\nthree */\n  mode a;\n}\n");
}

TEST(Format, WidthsAreCountedInCodePoints) {
  const std::string wide = "x" + std::string(37, 'y');
  const std::string text = "property \"a\" { never " + wide + " ≠ on ∧ " + wide + " ≠ off1; }";
  const auto formatted = format(text, Kind::properties);
  ASSERT_TRUE(formatted);
  EXPECT_EQ(std::count(formatted->begin(), formatted->end(), '\n'), 3);
}

TEST(Format, WhatDependsOnBlanksOnlyIsTheSameForAll) {
  EXPECT_EQ(format("A()::{do{x=on}watching y=off}", Kind::program),
            format("A ( )\n::\n{\tdo {\nx\n=\non } watching\n\ny = off\n}", Kind::program));
}

/// Deep and wide at once: the cost of a layout is that of its length.
TEST(Format, NestingCostsNothing) {
  std::string constraint = "x = y";
  for (int i = 0; i < 390; ++i) constraint = "(" + constraint + " & x = y)";
  const auto formatted = format("property \"a\" { never " + constraint + "; }", Kind::properties);
  ASSERT_TRUE(formatted);
  EXPECT_EQ(format(*formatted, Kind::properties), formatted);
}

TEST(LayoutDifference, NamesLinesAsPatchDoes) {
  EXPECT_EQ(layout_difference("a\n", "a\n", "f"), "");
  EXPECT_EQ(layout_difference("a b\n", "a\nb\n", "f"), "--- f\n+++ f\n@@ -1 +1,2 @@\n-a b\n+a\n+b\n");
  EXPECT_EQ(layout_difference("a", "a\n", "f"), "--- f\n+++ f\n@@ -1 +1 @@\n-a\n\\ No newline at end of file\n+a\n");
  EXPECT_EQ(layout_difference("\n\na\n", "a\n", "f"), "--- f\n+++ f\n@@ -1,3 +1 @@\n-\n-\n a\n");
}

}  // namespace
}  // namespace rmpl::compiler
