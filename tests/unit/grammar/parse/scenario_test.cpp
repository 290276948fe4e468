// Scenarios: every statement.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/unit/grammar/parse/trees.hpp"

namespace rmpl::grammar {
namespace {

using test::Parsed;

std::vector<ScenarioItem> items(const std::string& text) {
  const Parsed<ScenarioFile> result(parse_scenarios, "scenario \"s\" {" + text + "}");
  EXPECT_TRUE(result.tree) << result.errors();
  return result.tree ? result.tree->scenarios.at(0).items : std::vector<ScenarioItem>{};
}

TEST(ScenarioParse, Settings) {
  const auto all = items(R"(program "p.rmpl" main Entry; plant "q.tcca" rules only; cycle 0.5 s; duration 6 h;
                            seed 18446744073709551615; truth engine = off, lander = connected;)");
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(std::get<ProgramPart>(all[0]).main->text, "Entry");
  EXPECT_TRUE(std::get<PlantPart>(all[1]).rules_only);
  EXPECT_EQ(std::get<CyclePart>(all[2]).period.text(), "0.5s");
  EXPECT_EQ(std::get<DurationPart>(all[3]).duration.text(), "6h");
  EXPECT_EQ(std::get<SeedPart>(all[4]).seed, 18446744073709551615u);
  EXPECT_EQ(std::get<TruthPart>(all[5]).modes.size(), 2u);
}

TEST(ScenarioParse, Events) {
  const auto all = items(
      "at 16498 s fault lander = stuck; at 100 s observe engine.temp = low for 20 s;"
      "at 0 observe engine.temp = low; at 3 s command engine.cmd = on for 2; at 4 s command engine.cmd = off;");
  EXPECT_EQ(std::get<FaultEvent>(all.at(0)).mode.value.text, "stuck");
  EXPECT_EQ(std::get<ObserveEvent>(all.at(1)).duration->text(), "20s");
  EXPECT_FALSE(std::get<ObserveEvent>(all.at(2)).duration);
  EXPECT_EQ(std::get<CommandEvent>(all.at(3)).command.value.text, "on");
  EXPECT_EQ(std::get<CommandEvent>(all.at(3)).duration->text(), "2");
  EXPECT_FALSE(std::get<CommandEvent>(all.at(4)).duration);
}

TEST(ScenarioParse, Samples) {
  const auto all = items("at 3 s channel \"P1\" = -2.70; at 0 channel \"a \\\"b\\\"\" = \"ON\";");
  const auto& number = std::get<ChannelEvent>(all.at(0));
  EXPECT_EQ(number.channel.text, "P1");
  EXPECT_EQ(std::get<Number>(number.sample).value, -2.7);
  EXPECT_EQ(std::get<Number>(number.sample).text, "-2.70");
  EXPECT_EQ(std::get<ChannelEvent>(all.at(1)).channel.text, "a \"b\"");
  EXPECT_EQ(std::get<String>(std::get<ChannelEvent>(all.at(1)).sample).text, "ON");
}

TEST(ScenarioParse, Rules) {
  const auto all = items(
      "when command c = on after 86 cycles observe t = low;"
      "when estimate e = on | f = on after 5 min observe t = low for 3; when command c = on observe t = x;");
  EXPECT_EQ(std::get<Cycles>(*std::get<RuleText>(all.at(0)).delay).count, 86u);
  const auto& second = std::get<RuleText>(all.at(1));
  EXPECT_EQ(second.stream, RuleText::Stream::estimate);
  EXPECT_EQ(std::get<Duration>(*second.delay).text(), "5min");
  EXPECT_EQ(test::tree(second.trigger), "(| e=on f=on)");
  EXPECT_EQ(second.duration->text(), "3");
  EXPECT_FALSE(std::get<RuleText>(all.at(2)).delay);
}

TEST(ScenarioParse, Expectations) {
  const auto all = items(
      "expect a = x within 60 s after b = y; expect a = x after b = y within 60 s; expect never a = x;"
      "expect truth never a = x; expect finished; expect finished within 5 h; expect a = x;");
  for (std::size_t i : {0u, 1u}) {
    const auto& both = std::get<ExpectText>(all.at(i));
    EXPECT_EQ(both.kind, ExpectText::Kind::eventually);
    EXPECT_EQ(both.within->text(), "60s");
    EXPECT_EQ(test::tree(*both.after), "b=y");
  }
  EXPECT_EQ(std::get<ExpectText>(all.at(2)).kind, ExpectText::Kind::never);
  EXPECT_TRUE(std::get<ExpectText>(all.at(3)).truth);
  EXPECT_EQ(std::get<ExpectText>(all.at(4)).kind, ExpectText::Kind::finished);
  EXPECT_FALSE(std::get<ExpectText>(all.at(4)).condition);
  EXPECT_EQ(std::get<ExpectText>(all.at(5)).within->text(), "5h");
}

TEST(ScenarioParse, HowAProgramIsToEndAndWhatIsNeverToCome) {
  const auto all = items("expect finished with a = x within 5 h; expect never goal-conflict; expect never no-plan;");
  const auto& finished = std::get<ExpectText>(all.at(0));
  EXPECT_EQ(finished.kind, ExpectText::Kind::finished);
  EXPECT_EQ(test::tree(*finished.condition), "a=x");
  EXPECT_EQ(finished.within->text(), "5h");
  EXPECT_EQ(std::get<ExpectText>(all.at(1)).kind, ExpectText::Kind::goal_conflict);
  EXPECT_EQ(std::get<ExpectText>(all.at(2)).kind, ExpectText::Kind::no_plan);
}

TEST(ScenarioParse, AProgramThatIsToGoOn) {
  const auto all =
      items("expect never finished; expect never finished with a = x within 5 h; expect never finished = x;");
  EXPECT_EQ(std::get<ExpectText>(all.at(0)).kind, ExpectText::Kind::never_finished);
  EXPECT_FALSE(std::get<ExpectText>(all.at(0)).condition);
  EXPECT_EQ(std::get<ExpectText>(all.at(1)).kind, ExpectText::Kind::never_finished);
  EXPECT_EQ(test::tree(*std::get<ExpectText>(all.at(1)).condition), "a=x");
  EXPECT_EQ(std::get<ExpectText>(all.at(1)).within->text(), "5h");
  EXPECT_EQ(std::get<ExpectText>(all.at(2)).kind, ExpectText::Kind::never);
  EXPECT_EQ(test::tree(*std::get<ExpectText>(all.at(2)).condition), "finished=x");
}

TEST(ScenarioParse, Requirements) {
  const auto all = items(
      "requirement \"R-1\", \"R-2\"; expect a = x within 5 s requirement \"R-3\";"
      "expect finished requirement \"R-4\"; expect never no-plan requirement \"R-5\"; expect requirement = x;");
  EXPECT_EQ(std::get<RequirementPart>(all.at(0)).tags.at(1).text, "R-2");
  for (std::size_t i = 1; i < 4; ++i) {
    const auto& expected = std::get<ExpectText>(all.at(i));
    ASSERT_TRUE(expected.requirement);
    EXPECT_EQ(expected.requirement->tags.at(0).text, "R-" + std::to_string(i + 2));
  }
  EXPECT_EQ(test::tree(*std::get<ExpectText>(all.at(4)).condition), "requirement=x");
}

TEST(ScenarioParse, ItsKeywordsMayBeVariables) {
  const auto all = items(
      "expect truth = x; expect never in {x}; expect finished != x; expect truth truth = x;"
      "expect never no-plan = x;");
  EXPECT_FALSE(std::get<ExpectText>(all.at(0)).truth);
  EXPECT_EQ(std::get<ExpectText>(all.at(1)).kind, ExpectText::Kind::eventually);
  EXPECT_EQ(test::tree(*std::get<ExpectText>(all.at(2)).condition), "finished!=x");
  EXPECT_TRUE(std::get<ExpectText>(all.at(3)).truth);
  EXPECT_EQ(std::get<ExpectText>(all.at(4)).kind, ExpectText::Kind::never);
}

TEST(ScenarioParse, AFileHoldsSeveral) {
  const Parsed<ScenarioFile> result(parse_scenarios, R"(scenario "a \"quoted\" name" { } scenario "b" { })");
  ASSERT_TRUE(result.tree);
  ASSERT_EQ(result.tree->scenarios.size(), 2u);
  EXPECT_EQ(result.tree->scenarios[0].name.text, "a \"quoted\" name");
}

}  // namespace
}  // namespace rmpl::grammar
