// The sequencer alone: the walk of thesis 5.4, and what it says where knowledge or goals contradict themselves.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.hpp"
#include "runtime/executive/sequence/log_run.hpp"
#include "tests/unit/runtime/executive/cycle/mars_entry.hpp"

namespace rmpl::runtime {
namespace {

using Json = nlohmann::ordered_json;
using mars_entry::ProgramBuilder;
using namespace rmpl::automata;

std::vector<Json> sequence(const Program& program, const std::vector<Json>& log) {
  std::stringstream in;
  for (const Json& line : log) in << line.dump() << '\n';
  std::stringstream out;
  sequence_log(program, in, "log", [&out](std::string_view line) { out << line << '\n'; });
  std::vector<Json> lines;
  for (std::string line; std::getline(out, line);) lines.push_back(Json::parse(line));
  return lines;
}

Json state(double time, const char* engine, const char* nav, const char* att, const char* lander, const char* entry) {
  return {{"time", time},
          {"estimate", {{"engine", engine}, {"nav", nav}, {"att", att}, {"lander", lander}, {"entry", entry}}}};
}

struct Expected {
  double time;
  std::vector<int> marking;
  Json goal;
  Json clocks;
};

// Each line is a cycle that 5.4 describes, at the system time printed there; what the cycle reads back is the next
// line.
TEST(Sequence, WalksTheMarsEntryAsSection54Prints) {
  const char* cruise = "cruise-orient";
  const char* not_yet = "not-initiated";
  const std::vector<Json> log{
      state(0.0, "off", "earth-relative", cruise, "connected", not_yet),
      state(0.5, "heating", "earth-relative", cruise, "connected", not_yet),
      state(43.2, "heating", "earth-relative", cruise, "connected", not_yet),
      state(43.8, "standby", "earth-relative", cruise, "connected", not_yet),
      state(44.2, "standby", "earth-relative", cruise, "connected", not_yet),
      state(16244.0, "standby", "earth-relative", cruise, "connected", not_yet),
      state(16244.5, "standby", "earth-relative", cruise, "connected", not_yet),
      state(16245.1, "standby", "inertial", cruise, "connected", not_yet),
      state(16245.6, "standby", "inertial", cruise, "connected", not_yet),
      state(16485.5, "standby", "inertial", cruise, "connected", not_yet),
      state(16486.0, "standby", "inertial", cruise, "connected", not_yet),
      state(16498.2, "standby", "inertial", "slew-to-entry", "connected", not_yet),
      state(16498.8, "standby", "inertial", "entry-orient", "connected", not_yet),
      state(16499.3, "standby", "inertial", "entry-orient", "separated", not_yet),
      state(16600.0, "standby", "inertial", "entry-orient", "separated", "initiated"),
      state(16600.5, "standby", "inertial", "entry-orient", "separated", "initiated"),
      state(16601.0, "standby", "inertial", "entry-orient", "separated", "initiated"),
  };
  const Json standby{{"engine", "standby"}};
  const Json inertial{{"nav", "inertial"}};
  const Json orient{{"att", "entry-orient"}};
  const Json separate{{"att", "entry-orient"}, {"lander", "separated"}};
  const Json none = Json::object();
  const std::vector<Expected> expected{
      {0.0, {1, 2}, standby, none},
      {0.5, {1, 2}, standby, none},
      {43.2, {1, 2}, standby, none},
      {43.8, {1, 3}, none, none},
      {44.2, {1, 4}, none, {{"t1", 0.4}}},
      {16244.0, {1, 4}, none, {{"t1", 16200.2}}},
      {16244.5, {1, 5}, inertial, {{"t1", 16200.7}}},
      {16245.1, {1, 6}, none, {{"t1", 16201.3}}},
      {16245.6, {1, 7}, none, {{"t1", 16201.8}, {"t2", 0.5}}},
      {16485.5, {1, 7}, none, {{"t1", 16441.7}, {"t2", 240.4}}},
      {16486.0, {1, 8, 9, 10, 11}, orient, {{"t1", 16442.2}, {"t2", 240.9}}},
      {16498.2, {1, 8, 9, 10, 11}, orient, {{"t1", 16454.4}, {"t2", 253.1}}},
      {16498.8, {1, 8, 9, 10, 12}, separate, {{"t1", 16455.0}, {"t2", 253.7}}},
      {16499.3, {1, 8, 9, 10}, orient, {{"t1", 16455.5}, {"t2", 254.2}}},
      {16600.0, {1, 8, 9, 10}, none, {{"t1", 16556.2}, {"t2", 354.9}}},
      {16600.5, {}, none, {{"t1", 16556.7}, {"t2", 355.4}}},
  };
  const std::vector<Json> lines = sequence(mars_entry::program(), log);
  ASSERT_EQ(lines.size(), expected.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    SCOPED_TRACE("cycle " + std::to_string(i + 1));
    EXPECT_EQ(lines[i]["cycle"], i + 1);
    EXPECT_EQ(lines[i]["time"], expected[i].time);
    EXPECT_EQ(lines[i]["marking"], Json(expected[i].marking));
    EXPECT_EQ(lines[i]["goal"], expected[i].goal);
    EXPECT_EQ(lines[i]["clocks"], expected[i].clocks);
  }
}

TEST(Sequence, EndsWithTheFirstCycleThatStartsEmpty) {
  Program program;
  ProgramBuilder build(program);
  build.location(1, 0, true).composite = true;
  build.location(2, 1, true).goal = {build.assignment("a", "on")};
  const Json on{{"estimate", {{"a", "on"}}}};
  const auto lines = sequence(program, {on, on, on, on, on});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0]["marking"], Json({1, 2}));
  EXPECT_EQ(lines[1]["marking"], Json::array());
}

/// Two goals in parallel; the second can be made to agree with the first.
Program two_goals(const std::string& second) {
  Program program;
  ProgramBuilder build(program);
  program.locations.resize(3);
  build.location(1, 0, true).composite = true;
  build.location(2, 1, true).goal = {build.assignment("a", "on")};
  build.location(3, 1, true).goal = {build.assignment("a", second)};
  return program;
}

TEST(Sequence, ReportsGoalsThatContradictWithBothLocationsAndLines) {
  const Json off{{"estimate", {{"a", "off"}}}};
  const auto lines = sequence(two_goals("standby"), {off, off, off});
  ASSERT_EQ(lines.size(), 2U);
  for (const Json& line : lines) {
    EXPECT_EQ(line["goal"], Json::object());
    ASSERT_EQ(line["events"].size(), 1U);
    EXPECT_EQ(line["events"][0]["kind"], "goal-conflict");
    EXPECT_EQ(line["events"][0]["locations"], Json({2, 3}));
    EXPECT_EQ(line["events"][0]["message"],
              "location 2 asserts a = on (entry.rmpl:2:1), but location 3 asserts a = standby (entry.rmpl:3:1)");
  }
}

TEST(Sequence, GoalsThatAgreeAreOneGoal) {
  const Json off{{"estimate", {{"a", "off"}}}};
  const auto lines = sequence(two_goals("on"), {off, off});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0]["goal"], Json({{"a", "on"}}));
  EXPECT_FALSE(lines[0].contains("events"));
}

// Thesis 5.3, step 3: a clock that is active keeps its start when its location is marked again.
TEST(Sequence, AClockThatRunsIsNotStartedAgain) {
  Program program;
  program.clocks = {"t"};
  ProgramBuilder build(program);
  program.locations.resize(2);
  build.location(1, 0, true).composite = true;
  Location& again = build.location(2, 1, true);
  again.clock_start = ClockId(0);
  again.goal = {build.assignment("a", "on")};
  const auto at = [](double time) { return Json{{"time", time}, {"estimate", {{"a", "off"}}}}; };
  const auto lines = sequence(program, {at(1), at(2.5), at(4), at(6)});
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0]["clocks"], Json::object());
  EXPECT_EQ(lines[1]["clocks"], Json({{"t", 1.5}}));
  EXPECT_EQ(lines[2]["clocks"], Json({{"t", 3}}));
}

// Preemption: what is inside a composite that is violated asserts nothing, and what follows the composite goes on.
TEST(Sequence, PreemptionUnmarksTheInsideAtOnceAndGoesOnAfterIt) {
  Program program;
  ProgramBuilder build(program);
  program.locations.resize(4);
  build.location(1, 0, true).composite = true;
  build.location(2, 1, true).composite = true;
  program.locations[1].maintenance = {false, build.says("alarm", "yes")};
  build.location(3, 2, true).goal = {build.assignment("a", "on")};
  build.location(4, 1, false).goal = {build.assignment("a", "safe")};
  build.arc(2, 4);
  const auto at = [](const char* alarm) { return Json{{"estimate", {{"a", "off"}, {"alarm", alarm}}}}; };
  const auto lines = sequence(program, {at("no"), at("yes"), at("yes"), at("yes")});
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0]["goal"], Json({{"a", "on"}}));
  EXPECT_EQ(lines[1]["marking"], Json({1, 2, 3}));
  EXPECT_EQ(lines[1]["goal"], Json::object());
  EXPECT_EQ(lines[2]["marking"], Json({1, 4}));
  EXPECT_EQ(lines[2]["goal"], Json({{"a", "safe"}}));
}

// Without a plant a value that nobody mentions may be the one: x != v follows from no lack of knowledge.
TEST(Sequence, DomainsAreOpenWithoutAPlant) {
  Program program;
  ProgramBuilder build(program);
  program.locations.resize(3);
  build.location(1, 0, true).composite = true;
  build.location(2, 1, true);
  build.location(3, 1, false).goal = {build.assignment("a", "on")};
  build.wait(2, 3, negation(build.says("b", "low")));
  const Json unknown{{"estimate", {{"a", "off"}}}};
  const Json other{{"estimate", {{"a", "off"}, {"b", "medium"}}}};
  const auto lines = sequence(program, {unknown, unknown, other, other});
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[1]["marking"], Json({1, 2}));
  EXPECT_EQ(lines[2]["marking"], Json({1, 3}));
}

TEST(Sequence, ObservationsAreKnownInTheirCycleOnly) {
  Program program;
  ProgramBuilder build(program);
  program.locations.resize(3);
  build.location(1, 0, true).composite = true;
  build.location(2, 1, true);
  build.location(3, 1, false).goal = {build.assignment("a", "on")};
  build.wait(2, 3, build.says("sensor", "high"));
  const Json quiet{{"estimate", {{"a", "off"}}}};
  const Json seen{{"estimate", {{"a", "off"}}}, {"observations", {{"sensor", "high"}}}};
  const auto lines = sequence(program, {seen, quiet, seen, quiet});
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[1]["marking"], Json({1, 2}));
  EXPECT_EQ(lines[2]["marking"], Json({1, 3}));
}

}  // namespace
}  // namespace rmpl::runtime
