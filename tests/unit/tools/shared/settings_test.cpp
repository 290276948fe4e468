// rmpl.ini: what it may say, and what is said of the rest.
// SPDX-License-Identifier: MIT
#include "tools/shared/settings.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace rmpl::tools {
namespace {

using grammar::Code;
using grammar::Severity;

std::string refusal(const std::string& text) {
  try {
    read_settings("rmpl.ini", text);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Settings, AreReadInAnyOrder) {
  const Settings settings =
      read_settings("rmpl.ini",
                    "# ours\ncolor = never\nquiet = true\n\n[lint]\nRMPL0511 = note\nunused=error\n"
                    "style = off # loud\nlevel = note\ncycle = 100 ms\n");
  EXPECT_EQ(settings.options, (std::map<std::string, std::string>{{"color", "never"}, {"quiet", "true"}}));
  EXPECT_EQ(settings.level, Severity::note);
  EXPECT_EQ(settings.lint.cycle, automata::Ticks{automata::Ticks::per_second / 10});
  EXPECT_EQ(settings.lint.levels.at(Code::unused_clock), Severity::note);
  EXPECT_EQ(settings.lint.levels.at(Code::unused_domain), Severity::error);
  EXPECT_EQ(settings.lint.levels.at(Code::mixed_separators), std::nullopt);
  EXPECT_EQ(settings.lint.levels.count(Code::finer_than_cycle), 0);
}

TEST(Settings, SayWhereTheyAreWrong) {
  EXPECT_NE(
      refusal("[lint]\nunsued = off\n").find("rmpl.ini:2: unknown key 'lint.unsued'; did you mean 'lint.unused'?"),
      std::string::npos);
  EXPECT_EQ(refusal("[lint]\n\nunused = loud\n"),
            "rmpl.ini:3: 'lint.unused' is off, note, warning or error, not 'loud'");
  EXPECT_EQ(refusal("[lint]\nstyle = off\nstyle = note\n"), "rmpl.ini:3: 'lint.style' is given twice");
  EXPECT_EQ(refusal("no key %invalid_line%"),
            "rmpl.ini: expected lines 'key = value' and '[section]', found 'no key %invalid_line%'");
  EXPECT_EQ(refusal("[lint]\nlevel = off\n"), "rmpl.ini:2: 'lint.level' is note, warning or error");
  for (const char* text : {"[lint]\nRMPL0100 = off\n", "[lint]\n514 = off\n", "[lint]\ncycle = 0\n", "colour = auto\n",
                           "[lint\nx", "just a word\n", "[other]\ncolor = never\n"}) {
    EXPECT_EQ(refusal(text).substr(0, 8), "rmpl.ini") << text;
  }
}

}  // namespace
}  // namespace rmpl::tools
