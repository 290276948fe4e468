// The command line of tcca-check.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/command_line.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rmpl::verifier {
namespace {

ParsedCommandLine parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "tcca-check");
  return parse_command_line(static_cast<int>(arguments.size()), arguments.data(), "1.2.3");
}

TEST(CommandLine, ReadsAResponse) {
  const auto parsed = parse({"response", "m.tcca", "--after", "a = b", "--within", "30s", "c = d", "--time", "0.5s",
                             "--faults", "2", "--commands", "any", "--max-memory", "2K", "--color", "never"});
  ASSERT_TRUE(parsed.command_line) << parsed.message;
  const CommandLine& line = *parsed.command_line;
  EXPECT_EQ(line.kind, CommandLine::Kind::response);
  EXPECT_EQ(line.within, automata::Ticks::of_seconds(30));
  EXPECT_EQ(line.then, "c = d");
  EXPECT_EQ(line.period, automata::Ticks{500'000'000});
  EXPECT_EQ(line.faults, 2u);
  EXPECT_EQ(line.commands, Commands::any);
  EXPECT_EQ(line.max_bytes, 2048u);
  EXPECT_EQ(line.color, CommandLine::Color::never);
}

TEST(CommandLine, ReadsAWindow) {
  const auto parsed = parse({"reachability", "m.tcca", "--target", "x = y", "--not-before", "1 min", "--by", "90",
                             "--time", "dense", "--fastest", "--stats", "--format", "json"});
  ASSERT_TRUE(parsed.command_line) << parsed.message;
  EXPECT_EQ(parsed.command_line->not_before, automata::Ticks::of_seconds(60));
  EXPECT_EQ(parsed.command_line->by, automata::Ticks::of_seconds(90));
  EXPECT_EQ(parsed.command_line->period, std::nullopt);
  EXPECT_TRUE(parsed.command_line->fastest);
}

TEST(CommandLine, SaysWhatIsWrong) {
  const std::vector<std::vector<const char*>> wrong = {
      {},
      {"reachability", "m.tcca"},
      {"reachability", "--target", "x = y"},
      {"reachability", "m.tcca", "--target", "x = y", "--time", "0"},
      {"reachability", "m.tcca", "--target", "x = y", "--time", "often"},
      {"reachability", "m.tcca", "--target", "x = y", "--faults", "-1"},
      {"reachability", "m.tcca", "--target", "x = y", "--commands", "two"},
      {"reachability", "m.tcca", "--target", "x = y", "--max-memory", "1T"},
      {"reachability", "m.tcca", "--target", "x = y", "--max-memory", "99999999999999999999"},
      {"reachability", "m.tcca", "--target", "x = y", "--max-memory", "99999999999G"},
      {"response", "m.tcca", "--after", "x = y", "--within", "5"},
      {"bogus"},
  };
  for (const auto& arguments : wrong) {
    const auto parsed = parse(arguments);
    EXPECT_FALSE(parsed.command_line);
    EXPECT_TRUE(parsed.failed);
    EXPECT_FALSE(parsed.message.empty());
  }
}

TEST(CommandLine, HelpAndVersionAreNoErrors) {
  EXPECT_EQ(parse({"--version"}).message, "tcca-check 1.2.3\n");
  for (const auto& arguments : {std::vector<const char*>{"--help"}, {"safety", "--help"}}) {
    const auto parsed = parse(arguments);
    EXPECT_FALSE(parsed.command_line);
    EXPECT_FALSE(parsed.failed);
    EXPECT_NE(parsed.message.find("--"), std::string::npos);
  }
}

TEST(CommandLine, ReadsAProgram) {
  const auto parsed = parse({"program",      "p.rmpl",       "m.tcca",
                             "--never",      "a = b",        "--never",
                             "a = c",        "--eventually", "a = d within 2 min",
                             "--eventually", "a = e",        "--within",
                             "5s",           "--check",      "no-plan,termination",
                             "--scenario",   "out.scn",      "--cycle",
                             "0.25s",        "--main",       "P"});
  ASSERT_TRUE(parsed.command_line) << parsed.message;
  const CommandLine& line = *parsed.command_line;
  EXPECT_EQ(line.kind, CommandLine::Kind::program);
  EXPECT_EQ(line.models, (std::vector<std::string>{"p.rmpl", "m.tcca"}));
  EXPECT_EQ(line.nevers, (std::vector<std::string>{"a = b", "a = c"}));
  ASSERT_EQ(line.eventuallys.size(), 2u);
  EXPECT_EQ(line.eventuallys[0].constraint, "a = d");
  EXPECT_EQ(line.eventuallys[0].within, automata::Ticks::of_seconds(120));
  EXPECT_EQ(line.eventuallys[1].within, automata::Ticks::of_seconds(5));
  using Kind = ProgramProperty::Kind;
  EXPECT_EQ(line.general, (std::vector<Kind>{Kind::no_plan, Kind::termination}));
  EXPECT_EQ(line.cycle, automata::Ticks{250'000'000});
  EXPECT_EQ(line.entry, "P");
}

TEST(CommandLine, APromiseNeedsATime) {
  const auto parsed = parse({"program", "p.rmpl", "m.tcca", "--eventually", "a = b"});
  EXPECT_TRUE(parsed.failed);
  EXPECT_NE(parsed.message.find("--within"), std::string::npos) << parsed.message;
}

TEST(CommandLine, KnowsItsChecks) {
  EXPECT_TRUE(parse({"program", "p.rmpl", "m.tcca", "--check", "no-plans"}).failed);
  EXPECT_TRUE(parse({"program", "p.rmpl", "m.tcca", "x.tcca"}).failed);
  EXPECT_TRUE(parse({"program", "p.rmpl", "m.tcca", "--each-fault", "--scenario", "o.scn"}).failed);
}

}  // namespace
}  // namespace rmpl::verifier
