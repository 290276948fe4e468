// SARIF and workflow commands, as the services that read them want them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "grammar/source/render.hpp"

namespace rmpl::grammar {
namespace {

Sources sources() {
  Sources sources;
  sources.add("a b/ü:,.rmpl", "one\nzwei ü\nthree\n");
  sources.add("/models/b.rmpl", "four\n");
  return sources;
}

Diagnostic finding() {
  return {Code::mixed_separators,
          Severity::note,
          {0, 4, 11},
          "100% :, sure\nor not",
          {{{1, 0, 4}, "here"}},
          "mend it",
          {{{1, 0, 0}, "x"}, {{0, 0, 3}, ""}, {{1, 4, 4}, "y"}}};
}

TEST(Github, EscapesAsItsToolkitDoes) {
  const std::vector found{finding()};
  EXPECT_EQ(render_github(found, sources()),
            "::notice file=a b/ü%3A%2C.rmpl,line=2,endLine=2,col=1,endColumn=6,title=RMPL0514%3A `%2C` and `;` in the "
            "same braces::100%25 :, sure%0Aor not%0A/models/b.rmpl:1: here%0Ahelp: mend it\n");
}

TEST(Github, GivesColumnsWithinOneLineOnly) {
  Diagnostic several = finding();
  several.span = {0, 4, 15};
  several.notes.clear();
  several.suggestion.reset();
  several.severity = Severity::error;
  const std::vector found{several};
  EXPECT_EQ(render_github(found, sources()).substr(0, 55), "::error file=a b/ü%3A%2C.rmpl,line=2,endLine=3,title=R");
}

TEST(Sarif, NamesPagesWhereTheProjectHasAnAddress) {
  const Diagnostic found[] = {{Code::syntax, Severity::error, {0, 0, 1}, "x", {}, {}, {}}};
  const auto driver = [&](const Tool& tool) {
    return nlohmann::json::parse(render_sarif(found, sources(), tool))["runs"][0]["tool"]["driver"];
  };
  const auto with = driver({"rmplc", "1.2.3", "https://rmpl.example"});
  EXPECT_EQ(with["informationUri"], "https://rmpl.example");
  EXPECT_EQ(with["rules"][0]["helpUri"], "https://rmpl.example/docs/diagnostics/" + to_string(Code::syntax) + ".md");
  const auto without = driver({"rmplc", "1.2.3"});
  EXPECT_FALSE(without.contains("informationUri"));
  EXPECT_FALSE(without["rules"][0].contains("helpUri"));
}

TEST(Sarif, HasRulesRegionsNotesAndFixesByFile) {
  const std::vector found{finding(), finding()};
  const auto log = nlohmann::json::parse(render_sarif(found, sources(), {"rmplc", "1.2.3"}));
  const auto& run = log.at("runs").at(0);
  EXPECT_EQ(run["tool"]["driver"]["version"], "1.2.3");
  EXPECT_EQ(run["tool"]["driver"]["rules"].size(), 1);
  EXPECT_EQ(run["tool"]["driver"]["rules"][0]["id"], "RMPL0514");
  ASSERT_EQ(run["results"].size(), 2);
  const auto& result = run["results"][1];
  EXPECT_EQ(result["level"], "note");
  EXPECT_EQ(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "a%20b/%C3%BC%3A%2C.rmpl");
  EXPECT_EQ(result["locations"][0]["physicalLocation"]["region"],
            nlohmann::json({{"startLine", 2}, {"startColumn", 1}, {"endLine", 2}, {"endColumn", 7}}));
  EXPECT_EQ(result["relatedLocations"][0]["physicalLocation"]["artifactLocation"]["uri"], "file:///models/b.rmpl");
  const auto& changes = result["fixes"][0]["artifactChanges"];
  ASSERT_EQ(changes.size(), 2);
  EXPECT_EQ(changes[0]["replacements"].size(), 2);
  EXPECT_EQ(changes[1]["replacements"][0]["insertedContent"]["text"], "");
}

TEST(Sarif, TellsWhatIsAllowedWithItsReason) {
  const std::vector<AllowedFinding> allowed{{finding(), "the pump is bought", {0, 0, 3}}};
  const auto log = nlohmann::json::parse(render_sarif({}, sources(), {"rmplc", "1.2.3"}, allowed));
  const auto& run = log.at("runs").at(0);
  EXPECT_EQ(run["tool"]["driver"]["rules"].size(), 1);
  ASSERT_EQ(run["results"].size(), 1);
  const auto& suppression = run["results"][0]["suppressions"].at(0);
  EXPECT_EQ(suppression["kind"], "inSource");
  EXPECT_EQ(suppression["justification"], "the pump is bought");
  EXPECT_EQ(suppression["location"]["physicalLocation"]["region"]["startLine"], 1);
}

}  // namespace
}  // namespace rmpl::grammar
