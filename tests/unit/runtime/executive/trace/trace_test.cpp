// Logs are read strictly, and JSON is written so that it reads back.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/executive/trace/log.hpp"

namespace rmpl::runtime {
namespace {

using namespace rmpl::automata;

Plant lamp() {
  Plant plant;
  plant.name = "house";
  Component lamp;
  lamp.name = "lamp";
  lamp.mode = plant.variables.add({"lamp", {"off", "on"}});
  lamp.modes.resize(2);
  lamp.modes[0].name = "off";
  lamp.modes[1].name = "on";
  lamp.initial = {1, 0};
  plant.components.push_back(lamp);
  const VariableId cmd = plant.variables.add({"lamp.cmd", {"none", "on"}});
  plant.variables.add({"lamp.light", {"dark", "bright"}});
  plant.controls.push_back({cmd, ValueId(0)});
  plant.observables.push_back(VariableId(2));
  return plant;
}

std::string error_of(const std::string& text) {
  std::istringstream in(text);
  try {
    read_log(in, "in.jsonl", lamp());
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Log, ReadsWhatALineSaysAndLeavesTheRestEmpty) {
  std::istringstream in(R"({"time": 0.5, "command": {"lamp.cmd": "on"}, "observations": {"lamp.light": "dark"}}

{"cycle": 2, "estimate": {"lamp": "on"}, "truth": {"lamp": "on"}, "belief": [], "events": [], "goal": {}, "marking": [1]}
{"time": "2 min"}
)");
  const auto lines = read_log(in, "in.jsonl", lamp());
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].number, 1U);
  EXPECT_EQ(lines[0].time.count, Ticks::per_second / 2);
  EXPECT_EQ(lines[0].command, (std::vector<Assignment>{{VariableId(1), ValueId(1)}}));
  EXPECT_EQ(lines[0].observations, (Observation{{VariableId(2), ValueId(0)}}));
  EXPECT_FALSE(lines[0].estimate);
  EXPECT_EQ(lines[1].number, 3U);
  EXPECT_EQ(lines[1].cycle, 2U);
  EXPECT_EQ(lines[1].time, lines[0].time);
  EXPECT_EQ(lines[1].estimate, (std::vector<Assignment>{{VariableId(0), ValueId(1)}}));
  EXPECT_EQ(lines[2].time, Ticks::of_seconds(120));
}

TEST(Log, ErrorsNameFileLineAndWhatWasExpected) {
  EXPECT_EQ(error_of("{}\n[1]\n"), "in.jsonl:2: expected a JSON object, not array");
  EXPECT_EQ(error_of("{\"time\": }"), "in.jsonl:1:10: not JSON; expected one object a line");
  EXPECT_EQ(error_of("{\"time\": NaN}"), "in.jsonl:1:10: not JSON; expected one object a line");
  EXPECT_EQ(error_of("{\"time\": 1e999}"), "in.jsonl:1: a number is out of range");
  EXPECT_EQ(error_of("{\"time\": -1}"),
            "in.jsonl:1: 'time': expected seconds from 0 to 9.2e9 in whole nanoseconds, or a duration with a unit, not "
            "-1");
  EXPECT_EQ(error_of("{\"time\": 1e12}"),
            "in.jsonl:1: 'time': expected seconds from 0 to 9.2e9 in whole nanoseconds, or a duration with a unit, not "
            "1e12");
  EXPECT_EQ(error_of("{\"time\": 1, \"time\": 2}"), "in.jsonl:1: /time: the key 'time' stands twice in one object");
  EXPECT_EQ(error_of("{\"command\": {\"lamp.cmd\": \"on\", \"lamp.cmd\": \"none\"}}"),
            "in.jsonl:1: /command/lamp.cmd: the key 'lamp.cmd' stands twice in one object");
  EXPECT_EQ(error_of("{\"time\": 2}\n{\"time\": 1}\n"),
            "in.jsonl:2: the time 1 s lies before that of an earlier line, 2 s");
  EXPECT_EQ(error_of("{\"observation\": {}}"), "in.jsonl:1: unknown key 'observation'; did you mean 'observations'?");
  EXPECT_EQ(error_of("{\"estimate\": {\"lamb\": \"on\"}}"),
            "in.jsonl:1: 'lamb' is no component of plant 'house'; did you mean 'lamp'?");
  EXPECT_EQ(error_of("{\"command\": {\"lamp.light\": \"dark\"}}"),
            "in.jsonl:1: 'lamp.light' is no control variable of plant 'house'");
  EXPECT_EQ(error_of("{\"observations\": {\"lamp.light\": \"brigth\"}}"),
            "in.jsonl:1: 'brigth' is no value of 'lamp.light'; did you mean 'bright'?");
  EXPECT_EQ(error_of("{\"observations\": {\"lamp\": \"on\"}}"),
            "in.jsonl:1: 'lamp' is a component: no sensor reads its mode; expected an attribute");
  EXPECT_EQ(error_of("{\"estimate\": {\"lamp\": true}}"),
            "in.jsonl:1: 'estimate.lamp': expected a value as a string, not boolean");
  EXPECT_EQ(error_of("{\"cycle\": -1}"), "in.jsonl:1: 'cycle': expected a whole number, not -1");
  EXPECT_EQ(error_of("{\"marking\": {}}"), "in.jsonl:1: 'marking': expected an array, not object");
  EXPECT_EQ(error_of("{\"estimate\": null}"),
            "in.jsonl:1: 'estimate': expected an object of names and values, not null");
}

// Where a double has not enough digits: each decimal is its tick, or an error.
TEST(Log, TimesAreExact) {
  for (const char* decimal : {"9007199.254740993", "0.000000001", "9223372036.854775806", "4e-9", "1.5e1"}) {
    std::istringstream in("{\"cycle\": 1, \"time\": " + std::string(decimal) + "}");
    EXPECT_EQ(read_log(in, "in.jsonl", lamp()).front().time, *parse_duration(decimal)) << decimal;
  }
  for (const char* decimal : {"1e-10", "0.0000000015", "9223372036.854775807", "1e-400", "-0.5"}) {
    EXPECT_EQ(error_of("{\"time\": " + std::string(decimal) + "}"),
              "in.jsonl:1: 'time': expected seconds from 0 to 9.2e9 in whole nanoseconds, or a duration with a unit, "
              "not " +
                  std::string(decimal));
  }
}

TEST(Log, KnowsWhenTheCyclesWereThatALineLeavesOut) {
  std::istringstream in("{\"cycle\": 3, \"time\": 1.5}\n{\"cycle\": 7, \"time\": 3.5, \"unchanged\": 3}\n");
  const auto lines = read_log(in, "in.jsonl", lamp());
  EXPECT_EQ(lines[0].unchanged, 0U);
  EXPECT_EQ(lines[1].unchanged, 3U);
  EXPECT_EQ(lines[1].time_of_unchanged(1), Ticks::of_seconds(2));
  EXPECT_EQ(lines[1].time_of_unchanged(3), Ticks::of_seconds(3));
  EXPECT_EQ(error_of("{\"unchanged\": 1}"),
            "in.jsonl:1: 'unchanged': expected a line before it that the cycles left out are like");
  EXPECT_EQ(error_of("{\"cycle\": 3}\n{\"cycle\": 5, \"unchanged\": 2}"),
            "in.jsonl:2: 'unchanged': 2 cycles cannot have been left out between cycle 3 and cycle 5");
  EXPECT_EQ(error_of("{}\n{\"unchanged\": 0.5}"), "in.jsonl:2: 'unchanged': expected a whole number, not 0.5");
}

TEST(Log, SurvivesHostileLines) {
  EXPECT_EQ(error_of(std::string(100'000, '[')), "in.jsonl:1:100001: not JSON; expected one object a line");
  EXPECT_NE(error_of(std::string("{\"a\0\": 1}", 9)), "no error");
  EXPECT_NE(error_of("{\"estimate\": {\"\xff\": \"on\"}}"), "no error");
}

TEST(Log, TakesNamesAsTheyComeWithoutAPlant) {
  Variables variables;
  std::istringstream in(R"({"estimate": {"a": "x"}}
{"estimate": {"a": "y"}, "observations": {"b": "z"}})");
  const auto lines = read_log(in, "in.jsonl", variables);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(variables[VariableId(0)], (Variable{"a", {"x", "y"}}));
  EXPECT_EQ(variables[VariableId(1)], (Variable{"b", {"z"}}));
}

TEST(JsonLine, WritesWhatReadsBack) {
  JsonLine line;
  line.open('{').key("a \"b\"\n").number(0.1).key("list").open('[').number(1U).string("x\\y").null().close(']');
  line.key("empty").open('{').close('}').key("time").seconds({43'200'000'000}).close('}');
  EXPECT_EQ(line.text(), "{\"a \\\"b\\\"\\u000a\":0.1,\"list\":[1,\"x\\\\y\",null],\"empty\":{},\"time\":43.2}");
  EXPECT_TRUE(nlohmann::json::accept(line.text()));
}

}  // namespace
}  // namespace rmpl::runtime
