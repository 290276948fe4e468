// Where an allowance is read, and which line it speaks of.
// SPDX-License-Identifier: MIT
#include "compiler/lint/allowances.hpp"

#include <gtest/gtest.h>

#include "compiler/lint/lint.hpp"
#include "tests/unit/compiler/workspace.hpp"

namespace rmpl::compiler {
namespace {

std::vector<std::uint32_t> lines(const std::string& text, std::size_t wrong = 0) {
  grammar::Sources sources;
  sources.add("a.rmpl", text);
  grammar::Diagnostics found;
  std::vector<std::uint32_t> result;
  for (const Allowance& one : allowances_in(sources, 0, found)) result.push_back(one.line);
  EXPECT_EQ(found.all().size(), wrong) << text;
  return result;
}

TEST(Allowances, SpeakOfTheirLineOrOfTheNextOne) {
  using Lines = std::vector<std::uint32_t>;
  EXPECT_EQ(lines("x // lint: allow RMPL0514 because of it\n"), Lines{1});
  EXPECT_EQ(lines("  // lint: allow RMPL0514 because of it\nx"), Lines{2});
  EXPECT_EQ(lines("// lint: allow RMPL0514 because of it\n// and more\n//lint:allow RMPL0504,RMPL0505 because so\nx"),
            (Lines{4, 4, 4}));
  EXPECT_EQ(lines("/* // lint: allow RMPL0514 because of it */ \"// lint: allow\" // plain\n"), Lines{});
  EXPECT_EQ(lines("\"a\\\"// lint: x\" /* */ // lint: allow RMPL0514 because of it"), Lines{1});
  EXPECT_EQ(lines("// lint: allow RMPL0514 because of it\n\nx"), Lines{2});
}

TEST(Allowances, StandInEitherKindOfComment) {
  using Lines = std::vector<std::uint32_t>;
  EXPECT_EQ(lines("x /* lint: allow RMPL0514 because of it */\ny"), Lines{1});
  EXPECT_EQ(lines("/* lint: allow RMPL0514 because of it */ x\ny"), Lines{1});
  EXPECT_EQ(lines("/* lint: allow RMPL0514\n   because of it */\nx"), Lines{3});
  EXPECT_EQ(lines("/* lint: allow RMPL0514 because of it */\n/* and\n more */\n// of it\nx"), Lines{5});
  EXPECT_EQ(lines("/* lint: allow RMPL0514 because of it */\n/* and\n\n more */ x"), Lines{4});
  EXPECT_EQ(lines("/*lint:allow RMPL0514,RMPL0504 because so*/\nx"), (Lines{2, 2}));
  EXPECT_TRUE(lines("/* lint: allow RMPL0514 */", 1).empty());
  EXPECT_TRUE(lines("/* lint: allow RMPL0514 because */", 1).empty());
  EXPECT_TRUE(lines("/* lint: allow RMPL0514 because it is not closed").empty());
}

TEST(Allowances, NeedACodeOfLintAndAReason) {
  for (const char* text : {"// lint: allow RMPL0514", "// lint: allow RMPL0514 because", "// lint: allow because so",
                           "// lint: allow RMPL0100 because so", "// lint: allow 514 because so", "// lint: hush",
                           "// lint: allow RMPL0514 RMPL0504 because so"}) {
    EXPECT_TRUE(lines(text, 1).empty());
  }
}

class LintOfText : public Workspace {};

TEST_F(LintOfText, LevelsAreTheUsersAfterAllowances) {
  const Compilation compilation = compile_text("a.rmpl", "P() :: {\n  a = on; b = on, c = on\n}\n");
  ASSERT_TRUE(compilation.ok());
  EXPECT_EQ(lint(compilation).all().size(), 1);
  LintSettings settings;
  settings.levels[grammar::Code::mixed_separators] = grammar::Severity::error;
  EXPECT_TRUE(lint(compilation, settings).has_errors());
  settings.levels[grammar::Code::mixed_separators] = std::nullopt;
  EXPECT_TRUE(lint(compilation, settings).empty());
}

TEST(LintCodes, HaveAnEntryEachOnce) {
  grammar::Code last = grammar::Code::syntax;
  for (const LintCode& code : lint_codes()) {
    EXPECT_GT(code.code, last) << to_string(code.code);
    EXPECT_EQ(find_lint_code(code.code)->level, code.level);
    last = code.code;
  }
}

}  // namespace
}  // namespace rmpl::compiler
