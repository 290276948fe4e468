// Any name in DOT and in its labels.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/dot.hpp"

#include <gtest/gtest.h>

namespace rmpl::compiler {
namespace {

TEST(Dot, LeavesWordsAndNumbersBare) {
  EXPECT_EQ(dot_value("engine_1"), "engine_1");
  EXPECT_EQ(dot_value("42"), "42");
}

TEST(Dot, QuotesTheRest) {
  EXPECT_EQ(dot_value(""), "\"\"");
  EXPECT_EQ(dot_value("0.5"), "\"0.5\"");
  EXPECT_EQ(dot_value("4x"), "\"4x\"");
  EXPECT_EQ(dot_value("entry-orient"), "\"entry-orient\"");
  EXPECT_EQ(dot_value("\xc3\xa9tat"), "\"\xc3\xa9tat\"");
}

TEST(Dot, QuotesKeywordsInAnyCase) {
  EXPECT_EQ(dot_value("node"), "\"node\"");
  EXPECT_EQ(dot_value("Graph"), "\"Graph\"");
  EXPECT_EQ(dot_value("nodes"), "nodes");
}

TEST(Dot, EscapesQuotesAndBackslashes) {
  EXPECT_EQ(dot_value("a\"b"), "\"a\\\"b\"");
  EXPECT_EQ(dot_value("\\N"), "\"\\\\N\"");
  EXPECT_EQ(dot_value("end\\"), "\"end\\\\\"");
}

TEST(Dot, ShowsControlCharactersByNumber) { EXPECT_EQ(dot_value("a\x1b"), "\"a\\\\x1b\""); }

TEST(Dot, EscapesMarkup) {
  EXPECT_EQ(escaped("a <-> b & \"c\""), "a &lt;-&gt; b &amp; &quot;c&quot;");
  EXPECT_EQ(dot_label("<B>" + escaped("<B>") + "</B>"), "<<B>&lt;B&gt;</B>>");
}

TEST(Dot, KeepsWhatGraphvizWouldReplace) {
  EXPECT_EQ(escaped("\\E"), "&#92;&#8203;E");
  EXPECT_EQ(dot_tooltip("\\N & \"x\""), "\"&#92;&#8203;N &amp; &quot;x&quot;\"");
}

TEST(Dot, WritesAStatementALine) {
  DotText dot("a b");
  dot.set({{"rankdir", dot_value("LR")}});
  dot.open_cluster("c1", {{"label", dot_label("x")}});
  dot.node("n1", {{"shape", dot_value("box")}, {"width", dot_value("0.1")}});
  dot.close_cluster();
  dot.edge("n1", "n2", {});
  EXPECT_EQ(dot.finish(),
            "digraph \"a b\" {\n"
            "  rankdir=LR;\n"
            "  subgraph cluster_c1 {\n"
            "    label=<x>;\n"
            "    n1 [shape=box, width=\"0.1\"];\n"
            "  }\n"
            "  n1 -> n2;\n"
            "}\n");
}

}  // namespace
}  // namespace rmpl::compiler
