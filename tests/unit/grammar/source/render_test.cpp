// Diagnostics as text and as JSON.
// SPDX-License-Identifier: MIT
#include "grammar/source/render.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace rmpl::grammar {
namespace {

std::string text_of(const Sources& sources, const Diagnostics& diagnostics, bool color = false) {
  return render_text(diagnostics.sorted(), sources, color);
}

TEST(RenderText, ShowsLineCaretsNotesAndHelp) {
  Sources sources;
  sources.add("engine.tcca", "mode off;\nmode off { thurst = zero };\n");
  Diagnostics diagnostics;
  Diagnostic& error = diagnostics.error(Code::duplicate_name, {0, 15, 18}, "mode `off` is defined twice");
  error.notes.push_back({{0, 5, 8}, "first defined here"});
  error.suggestion = "rename one of them";
  EXPECT_EQ(text_of(sources, diagnostics), R"(error[RMPL0101]: mode `off` is defined twice
 --> engine.tcca:2:6
  |
2 | mode off { thurst = zero };
  |      ^^^
note: first defined here
 --> engine.tcca:1:6
  |
1 | mode off;
  |      ---
help: rename one of them

)");
}

TEST(RenderText, CountsColumnsNotBytesAndWidensTabs) {
  Sources sources;
  sources.add("f", "\tt ≥ x");
  Diagnostics diagnostics;
  diagnostics.error(Code::syntax, {0, 7, 8}, "m");
  EXPECT_EQ(text_of(sources, diagnostics), "error[RMPL0001]: m\n --> f:1:6\n  |\n1 |     t ≥ x\n  |         ^\n\n");
}

TEST(RenderText, MarksPlacesAtTheEndAndSpansOfSeveralLines) {
  Sources sources;
  sources.add("f", "ab\ncd");
  Diagnostics diagnostics;
  diagnostics.error(Code::syntax, {0, 1, 4}, "m");
  diagnostics.error(Code::syntax, {0, 5, 5}, "n");
  EXPECT_EQ(text_of(sources, diagnostics),
            "error[RMPL0001]: m\n --> f:1:2\n  |\n1 | ab\n  |  ^…\n\n"
            "error[RMPL0001]: n\n --> f:2:3\n  |\n2 | cd\n  |   ^\n\n");
}

TEST(RenderText, ShowsLongLinesThroughAWindow) {
  Sources sources;
  sources.add("f", std::string(1'000'000, 'x') + "HERE" + std::string(1'000'000, 'y'));
  Diagnostics diagnostics;
  diagnostics.error(Code::syntax, {0, 1'000'000, 1'000'004}, "m");
  const std::string text = text_of(sources, diagnostics);
  EXPECT_LT(text.size(), 400u);
  EXPECT_NE(text.find("1 | …" + std::string(30, 'x') + "HERE" + std::string(86, 'y') + "…\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("\n  | " + std::string(31, ' ') + "^^^^\n"), std::string::npos) << text;
}

TEST(RenderText, ColoursOnlyWhereAsked) {
  Sources sources;
  sources.add("f", "x");
  Diagnostics diagnostics;
  diagnostics.warning(Code::syntax, {0, 0, 1}, "m");
  EXPECT_EQ(text_of(sources, diagnostics).find('\x1b'), std::string::npos);
  EXPECT_NE(text_of(sources, diagnostics, true).find("\x1b[1;33mwarning[RMPL0001]\x1b[0m"), std::string::npos);
}

TEST(RenderText, TheEmptyTextHasNoLineToShow) {
  Sources sources;
  sources.add("f", "");
  Diagnostics diagnostics;
  diagnostics.error(Code::no_plant, {0, 0, 0}, "m");
  EXPECT_EQ(text_of(sources, diagnostics), "error[RMPL0207]: m\n --> f:1:1\n\n");
}

TEST(RenderText, CutsWordsThatNobodyReads) {
  Sources sources;
  sources.add("f", "");
  Diagnostics diagnostics;
  std::string name(99, 'x');
  for (int i = 0; i < 1000; ++i) name += "≥";
  diagnostics.error(Code::no_plant, {0, 0, 0}, "no `" + name + "` here, " + std::string(200, 'y'));
  const std::string text = text_of(sources, diagnostics);
  EXPECT_EQ(text,
            "error[RMPL0207]: no `" + std::string(99, 'x') + "… here, " + std::string(200, 'y') + "\n --> f:1:1\n\n");
}

TEST(RenderJson, HasEveryKey) {
  Sources sources;
  sources.add("f", "a\nbc ≥\xFF");
  Diagnostics diagnostics;
  Diagnostic& error = diagnostics.error(Code::syntax, {0, 2, 8}, "m \xFF");
  error.notes.push_back({{0, 0, 1}, "n"});
  const auto json = nlohmann::json::parse(render_json(diagnostics.sorted(), sources));
  ASSERT_EQ(json.size(), 1u);
  EXPECT_EQ(json[0]["code"], "RMPL0001");
  EXPECT_EQ(json[0]["severity"], "error");
  EXPECT_EQ(json[0]["line"], 2);
  EXPECT_EQ(json[0]["column"], 1);
  EXPECT_EQ(json[0]["end_line"], 2);
  EXPECT_EQ(json[0]["end_column"], 5);
  EXPECT_EQ(json[0]["notes"][0]["message"], "n");
  EXPECT_TRUE(json[0]["suggestion"].is_null());
  EXPECT_EQ(render_json({}, sources), "[]\n");
}

TEST(Diagnostics, SortByPlaceAndDropDoubles) {
  Diagnostics diagnostics;
  diagnostics.error(Code::unknown_name, {1, 0, 1}, "c");
  diagnostics.warning(Code::syntax, {0, 5, 6}, "b");
  diagnostics.error(Code::syntax, {0, 2, 6}, "a");
  diagnostics.error(Code::syntax, {0, 2, 6}, "a");
  EXPECT_EQ(diagnostics.error_count(), 3u);
  const auto sorted = diagnostics.sorted();
  ASSERT_EQ(sorted.size(), 3u);
  EXPECT_EQ(sorted[0].message, "a");
  EXPECT_EQ(sorted[1].message, "b");
  EXPECT_EQ(sorted[2].message, "c");
}

}  // namespace
}  // namespace rmpl::grammar
