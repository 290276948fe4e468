// The command line of tcca-check.
// SPDX-License-Identifier: MIT
#include "verifier/command_line.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace verifier {
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

}  // namespace
}  // namespace verifier
