// rmpl.toml: what it may say, and what is said of the rest.
// SPDX-License-Identifier: MIT
#include "tools/shared/manifest.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"

namespace rmpl::tools {
namespace {

std::string refusal(const std::string& text) {
  try {
    read_manifest("rmpl.toml", text);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Manifest, HoldsSetsInTheOrderOfTheFile) {
  const Manifest manifest = read_manifest("x/rmpl.toml",
                                          "[project]\nname = \"p\"\n[set.z]\nplant = \"a.tcca\"\nprogram = 'b.rmpl'\n"
                                          "main = \"B\"\nscenarios = [\"c.scn\", \"d*.scn\"]\n[set.\"a b\"]\n"
                                          "properties = [\"e.props\"]\n");
  EXPECT_EQ(manifest.name, "p");
  ASSERT_EQ(manifest.sets.size(), 2);
  EXPECT_EQ(manifest.sets[0].name, "z");
  EXPECT_EQ(manifest.sets[0].plant->text, "a.tcca");
  EXPECT_EQ(manifest.sets[0].main->text, "B");
  ASSERT_EQ(manifest.sets[0].scenarios.size(), 2);
  EXPECT_EQ(manifest.sets[0].scenarios[1].text, "d*.scn");
  EXPECT_EQ(manifest.sets[0].scenarios[1].line, 7);
  EXPECT_EQ(manifest.sets[0].scenarios[1].column, 23);
  EXPECT_EQ(manifest.sets[1].name, "a b");
}

TEST(Manifest, HoldsLevelsAndOptions) {
  const Manifest manifest = read_manifest("rmpl.toml",
                                          "[lint]\nlevel = \"note\"\nstyle = \"off\"\nRMPL0511 = \"error\"\n"
                                          "[rmpl-run.scenario]\nk = 4\nestimator = \"exact\"\nfollow = true\n");
  EXPECT_EQ(manifest.lint.level(), grammar::Severity::note);
  EXPECT_EQ(manifest.lint.settings().levels.at(grammar::Code::unused_clock), grammar::Severity::error);
  EXPECT_EQ(manifest.lint.settings().levels.at(grammar::Code::mixed_separators), std::nullopt);
  const auto& options = manifest.options.at("rmpl-run.scenario");
  EXPECT_EQ(options.at("k").text, "4");
  EXPECT_EQ(options.at("estimator").text, "exact");
  EXPECT_EQ(options.at("follow").text, "true");
}

TEST(Manifest, SaysAllThatIsWrongAndWhere) {
  EXPECT_EQ(refusal("[projekt]\nname = \"x\"\n[lint]\nunused = \"loud\"\n[set.a]\nplant = 3\nscenario = [\"a.scn\"]\n"),
            "rmpl.toml:1:2: unknown key 'projekt'; did you mean 'project'?\n"
            "rmpl.toml:4:10: 'unused' is off, note, warning or error, not 'loud'\n"
            "rmpl.toml:6:1: 'plant' is a text, as in plant = \"…\"\n"
            "rmpl.toml:7:1: unknown key 'scenario' in [set.a]; did you mean 'scenarios'?");
  EXPECT_EQ(refusal("[set.a]\nmain = \"B\"\n"),
            "rmpl.toml:2:8: 'main' is a definition of the program, and there is none");
  EXPECT_EQ(refusal("[set.a]\nmonitors = [\"a.mon\"]\n"),
            "rmpl.toml:2:13: monitors speak of a plant: expected 'plant' in the set");
  EXPECT_EQ(refusal("[set.a]\n"), "rmpl.toml:1:6: set 'a' names no file");
  EXPECT_EQ(refusal("[set]\na = 1\n"), "rmpl.toml:2:1: expected a table, as in [set.a]");
  EXPECT_EQ(refusal("[rmplc.test]\njobs = [1]\n"), "rmpl.toml:2:1: 'jobs' is a text, a number, true or false");
  for (const char* text : {"[set.a\n", "a = 1\na = 2\n", "\xff", "x = 1", "[lint]\nlevel = \"off\"\n", "set = 1"}) {
    EXPECT_EQ(refusal(text).substr(0, 10), "rmpl.toml:") << text;
  }
}

TEST(Manifest, RefusesKeysThatAreVeryDeep) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "a.";
  for (const std::string& before : {std::string(), std::string("x = \"\"\"a\"b\"\"\"\n"),
                                    std::string("x = {\"#\" = 1, "), std::string("["), std::string("x = 'a\\'\n")}) {
    EXPECT_NE(refusal(before + deep + "b = 1\n").find("expected keys of at most 16 parts"), std::string::npos)
        << before;
  }
  EXPECT_EQ(refusal("# ...........................\n[project]\nname = \"..........................\"\n"), "");
}

TEST(Manifest, NamesFilesAsTheyAreSeenFromHere) {
  const std::string folder = testing::TempDir() + "manifest/";
  std::filesystem::create_directories(folder + "deep/er");
  for (const char* name : {"a.scn", "b.scn", "deep/c.scn", "deep/er/d.scn", "deep/.e.scn", "p.tcca"}) {
    std::ofstream(folder + name) << "x";
  }
  const auto files = [&](const std::string& scenarios) {
    const Manifest manifest =
        read_manifest(folder + "rmpl.toml", "[set.a]\nplant = \"p.tcca\"\nscenarios = [" + scenarios + "]\n");
    std::string text;
    for (const std::string& path : files_of(manifest, manifest.sets.front()).scenarios) {
      text += path.substr(folder.size()) + " ";
    }
    return text;
  };
  EXPECT_EQ(files("\"b.scn\", \"*.scn\""), "b.scn a.scn ");
  EXPECT_EQ(files("\"**/*.scn\""), "a.scn b.scn deep/c.scn deep/er/d.scn ");
  EXPECT_EQ(files("\"deep/**/d.scn\""), "deep/er/d.scn ");
  EXPECT_THROW(files("\"*.props\""), base::InputError);
  EXPECT_THROW(files("\"c.scn\""), base::InputError);
}

}  // namespace
}  // namespace rmpl::tools
