// Scenarios: what they lower to, and every error in them.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "grammar/source/render.hpp"
#include "tests/unit/compiler/workspace.hpp"

namespace rmpl::compiler {
namespace {

using automata::Ticks;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class Scenarios : public Workspace {
 protected:
  void SetUp() override {
    write("p.tcca", R"(component Engine {
  input cmd : { none, on };
  output temp : { low, high };
  mode off; mode on; fault failed; initial off;
  off -> on when cmd = on; any -> failed with 0.1;
}
plant Lander { engine : Engine; control engine.cmd default none; observe engine.temp; }
)");
    write("p.rmpl", "P() :: { engine = on }\n");
  }
  /// The findings in the parts of a scenario, which start on line 3.
  std::vector<std::string> in(const std::string& parts) {
    return errors("s.scn", "scenario \"s\" {\nprogram \"p.rmpl\"; plant \"p.tcca\";\n" + parts + "\n}\n");
  }
};

TEST_F(Scenarios, AreLowered) {
  const Compilation result = compile_text("s.scn", R"(scenario "one" {
  program "p.rmpl" main P;
  plant "p.tcca";
  cycle 0.25 s; duration 6 h; seed 7;
  truth engine = off;
  at 5 s fault engine = failed;
  at 1 s observe engine.temp = low for 20 s;
  at 4 s channel "T" = 2.50; at 5 s channel "T" = "n/a";
  at 2 s command engine.cmd = on; at 3 s command engine.cmd = none for 2 s;
  when command engine.cmd = on after 86 cycles observe engine.temp = high;
  when estimate engine = on after 3 s observe engine.temp = high for 5 s;
  expect engine = on within 60 s after engine = off;
  expect truth never engine = failed;
  expect finished within 5 h;
}
scenario "two" { program "p.rmpl"; plant "p.tcca" rules only; }
)");
  ASSERT_THAT(grammar::render_text(result.findings(), false), IsEmpty());
  const automata::Document& document = result.document();
  EXPECT_EQ(document.plants.size(), 1u);
  ASSERT_EQ(document.scenarios.size(), 2u);
  const automata::Scenario& one = document.scenarios[0];
  EXPECT_FALSE(one.rules_only);
  EXPECT_EQ(one.cycle, Ticks{Ticks::per_second / 4});
  EXPECT_EQ(one.duration, Ticks::of_seconds(6 * 3600));
  EXPECT_EQ(one.seed, 7u);
  ASSERT_EQ(one.truth.size(), 1u);
  ASSERT_EQ(one.forced.size(), 1u);
  EXPECT_EQ(one.forced[0].mode, automata::ModeId(2));
  ASSERT_EQ(one.overrides.size(), 1u);
  EXPECT_EQ(one.overrides[0].duration, Ticks::of_seconds(20));
  ASSERT_EQ(one.samples.size(), 2u);
  EXPECT_EQ(one.samples[0].number, 2.5);
  EXPECT_EQ(one.samples[0].text, "2.50");
  EXPECT_FALSE(one.samples[1].number);
  EXPECT_EQ(one.samples[1].text, "n/a");
  EXPECT_TRUE(one.monitors.empty());
  ASSERT_EQ(one.commands.size(), 2u);
  EXPECT_EQ(one.commands[0].duration, one.cycle);
  EXPECT_EQ(one.commands[1].duration, Ticks::of_seconds(2));
  ASSERT_EQ(one.rules.size(), 2u);
  EXPECT_EQ(one.rules[0].delay_cycles, 86u);
  EXPECT_TRUE(one.rules[0].duration.is_infinite());
  EXPECT_EQ(one.rules[1].stream, automata::Rule::Stream::estimate);
  EXPECT_EQ(one.rules[1].delay, Ticks::of_seconds(3));
  ASSERT_EQ(one.expectations.size(), 3u);
  EXPECT_EQ(one.expectations[0].text, "engine = on within 60 s after engine = off");
  EXPECT_EQ(one.expectations[0].within, Ticks::of_seconds(60));
  EXPECT_TRUE(one.expectations[0].after);
  EXPECT_TRUE(one.expectations[1].truth);
  EXPECT_EQ(one.expectations[1].kind, automata::Expectation::Kind::never);
  EXPECT_EQ(one.expectations[2].kind, automata::Expectation::Kind::finished);
  EXPECT_TRUE(document.scenarios[1].rules_only);
  EXPECT_EQ(document.programs[document.scenarios[1].program].variables, document.plants[0].variables);
}

TEST_F(Scenarios, RequirementsAreNamedOnce) {
  EXPECT_THAT(in("requirement \"R-1\", \"R-2\";\nexpect engine = on within 5 s requirement \"R-3\";"), IsEmpty());
  EXPECT_THAT(in("requirement \"R-1\", \"\";"), ElementsAre("RMPL0107 s.scn:3:20"));
  EXPECT_THAT(in("requirement \" R-1\";"), ElementsAre("RMPL0107 s.scn:3:13"));
  EXPECT_THAT(in("requirement \"R-1\"; requirement \"R-1\";"), ElementsAre("RMPL0108 s.scn:3:32"));
  EXPECT_THAT(in("expect engine = on requirement \"R-1\";\nrequirement \"R-1\";"), ElementsAre("RMPL0108 s.scn:3:32"));
  EXPECT_THAT(in("expect engine = on requirement \"R-1\"; expect never engine = failed requirement \"R-1\";"),
              IsEmpty());
}

TEST_F(Scenarios, WithRulesOnlyThereIsNoTruth) {
  const auto with_rules = [&](const std::string& parts) {
    return errors("s.scn", "scenario \"s\" {\nprogram \"p.rmpl\";\n" + parts + "\nplant \"p.tcca\" rules only;}\n");
  };
  EXPECT_THAT(with_rules("truth engine = off;"), ElementsAre("RMPL0407 s.scn:3:1"));
  EXPECT_THAT(with_rules("at 5 s fault engine = failed;"), ElementsAre("RMPL0407 s.scn:3:1"));
  EXPECT_THAT(with_rules("expect truth never engine = failed;"), ElementsAre("RMPL0407 s.scn:3:1"));
  EXPECT_THAT(with_rules("expect never engine = failed;"), IsEmpty());
}

TEST_F(Scenarios, MissingAndRepeatedParts) {
  EXPECT_THAT(errors("s.scn", "scenario \"s\" { }"), ElementsAre("RMPL0400 s.scn:1:10", "RMPL0400 s.scn:1:10"));
  EXPECT_THAT(in("program \"p.rmpl\";"), ElementsAre("RMPL0401 s.scn:3:1"));
  EXPECT_THAT(in("plant \"p.tcca\";"), ElementsAre("RMPL0401 s.scn:3:1"));
  EXPECT_THAT(in("seed 1; seed 2;"), ElementsAre("RMPL0401 s.scn:3:9"));
  EXPECT_THAT(in("cycle 1 s; cycle 2 s;"), ElementsAre("RMPL0401 s.scn:3:12"));
  EXPECT_THAT(in("truth engine = off, engine = on;"), ElementsAre("RMPL0401 s.scn:3:21"));
}

TEST_F(Scenarios, References) {
  EXPECT_THAT(in("truth engine.temp = low;"), ElementsAre("RMPL0402 s.scn:3:7"));
  EXPECT_THAT(in("at 1 s fault motor = failed;"), ElementsAre("RMPL0308 s.scn:3:14"));
  EXPECT_THAT(in("at 1 s observe engine = on;"), ElementsAre("RMPL0403 s.scn:3:16"));
  EXPECT_THAT(in("at 1 s observe engine.temp = hot;"), ElementsAre("RMPL0102 s.scn:3:30"));
  EXPECT_THAT(in("when command engine = on after 1 cycles observe engine.temp = low;"),
              ElementsAre("RMPL0404 s.scn:3:14"));
  EXPECT_THAT(in("when estimate engine.cmd = on after 1 cycles observe engine.temp = low;"),
              ElementsAre("RMPL0402 s.scn:3:15"));
  EXPECT_THAT(in("when command engine.cmd = on & !(false | engine = on) observe engine.temp = low;"),
              ElementsAre("RMPL0404 s.scn:3:42"));
  EXPECT_THAT(in("when estimate engine = on -> engine.temp in { low } observe engine.temp = low;"),
              ElementsAre("RMPL0402 s.scn:3:30"));
  EXPECT_THAT(in("expect engine = onn;"), ElementsAre("RMPL0102 s.scn:3:17"));
  EXPECT_THAT(in("expect t > 3 s;"), ElementsAre("RMPL0206 s.scn:3:8"));
  EXPECT_THAT(in("cycle 0 s;"), ElementsAre("RMPL0406 s.scn:3:7"));
}

TEST_F(Scenarios, EventsAfterTheEndAreWarnedOf) {
  const Compilation result = compile_text(
      "s.scn", "scenario \"s\" { program \"p.rmpl\"; plant \"p.tcca\"; duration 1 s;\nat 5 s fault engine = failed; }");
  EXPECT_TRUE(result.ok());
  EXPECT_THAT(findings(result), ElementsAre("RMPL0405 s.scn:2:1"));
}

TEST_F(Scenarios, FilesThatFail) {
  EXPECT_THAT(errors("s.scn", "scenario \"s\" { program \"p.rmpl\"; plant \"q.tcca\"; }"),
              ElementsAre("RMPL0006 s.scn:1:40"));
  EXPECT_THAT(errors("s.scn", "scenario \"s\" { program \"p.tcca\"; plant \"p.rmpl\"; }"),
              ElementsAre("RMPL0312 s.scn:1:24", "RMPL0207 s.scn:1:40"));
  EXPECT_THAT(errors("s.scn", "scenario \"s\" { program \"p.rmpl\" main Q; plant \"p.tcca\"; }"),
              ElementsAre("RMPL0307 s.scn:1:38"));
  write("bad.rmpl", "P() :: { motor = on }\n");
  EXPECT_THAT(errors("s.scn", "scenario \"s\" { program \"bad.rmpl\"; plant \"p.tcca\"; }"),
              ElementsAre("RMPL0308 bad.rmpl:1:10"));
}

TEST_F(Scenarios, NamesDiffer) {
  EXPECT_THAT(in("}\nscenario \"s\" { program \"p.rmpl\"; plant \"p.tcca\";"), ElementsAre("RMPL0101 s.scn:4:10"));
}

}  // namespace
}  // namespace rmpl::compiler
