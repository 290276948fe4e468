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
  EXPECT_EQ(error_of("{\"time\": -1}"), "in.jsonl:1: 'time': -1 lies before the start, time 0");
  EXPECT_EQ(error_of("{\"time\": 1e10}"), "in.jsonl:1: 'time': expected at most 292 years from the start, not 1e10");
  EXPECT_EQ(error_of("{\"time\": \"soon\"}"),
            "in.jsonl:1: 'time': expected seconds, a duration with a unit, a date or a mission time, not soon");
  EXPECT_EQ(error_of("{\"time\": true}"),
            "in.jsonl:1: 'time': expected seconds, a duration with a unit, a date or a mission time, not boolean");
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

// Where a double has not enough digits: each decimal is its tick, or the nearest one.
TEST(Log, TimesAreExact) {
  for (const char* decimal : {"9007199.254740993", "0.000000001", "9223372036.854775806", "4e-9", "1.5e1"}) {
    std::istringstream in("{\"cycle\": 1, \"time\": " + std::string(decimal) + "}");
    EXPECT_EQ(read_log(in, "in.jsonl", lamp()).front().time, *parse_duration(decimal)) << decimal;
  }
  for (const auto& [decimal, ticks] :
       {std::pair("0.30000000000000004", 300'000'000), {"1e-10", 0}, {"0.0000000015", 2}}) {
    std::istringstream in("{\"cycle\": 1, \"time\": " + std::string(decimal) + "}");
    EXPECT_EQ(read_log(in, "in.jsonl", lamp()).front().time.count, ticks) << decimal;
  }
  EXPECT_NE(error_of("{\"time\": 9223372036.854775807}"), "no error");
}

TEST(Log, LeavesOutOddSamplesAndNoSteps) {
  const auto read = [](const std::string& text, const LogTimeOptions& options) {
    std::istringstream in(text);
    const Plant plant = lamp();
    LogReader reader(in, "in.jsonl", plant);
    reader.read_times(options, LogReader::OddSamples::left_out);
    std::vector<std::int64_t> seconds;
    while (const auto line = reader.next()) seconds.push_back(line->time.count / Ticks::per_second);
    for (const std::string& line : reader.times().left_out()) ADD_FAILURE() << line;
    return seconds;
  };
  const std::string dark = R"(,"observations":{"lamp.light":"dark"}})";
  const auto sample = [&](const std::string& time) { return "{\"time\":" + time + dark + "\n"; };
  std::istringstream in(sample("1") + sample("2") + sample("2") + sample("1") + sample("3000") + sample("4"));
  const Plant plant = lamp();
  LogReader reader(in, "in.jsonl", plant);
  reader.read_times({}, LogReader::OddSamples::left_out);
  std::vector<std::int64_t> seconds;
  while (const auto line = reader.next()) seconds.push_back(line->time.count / Ticks::per_second);
  EXPECT_EQ(seconds, (std::vector<std::int64_t>{1, 2, 4}));
  EXPECT_EQ(reader.times().left_out(),
            (std::vector<std::string>{"1 sample out of order was left out, in line 4",
                                      "1 sample doubled was left out, in line 3",
                                      "1 sample in the wrong unit of time was left out, in line 5"}));
  EXPECT_EQ(read(sample("\"2023-11-14T22:13:20Z\"") + sample("1700000002"), {}), (std::vector<std::int64_t>{0, 2}));
  EXPECT_THROW(read(sample("2") + R"({"time":1,"command":{"lamp.cmd":"on"}})", {}), base::InputError);
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

TEST(Log, MakesLinesWholeThatTellChanges) {
  std::istringstream in(R"({"cycle": 3, "time": 1.5, "delta": true, "estimate": {"lamp": "on"}}
{"cycle": 4, "time": 2, "command": {"lamp.cmd": "on"}, "observations": {"lamp.light": "dark"}, "estimate": {"lamp": "off"}}
{"cycle": 7, "time": 3.5, "delta": true, "estimate": {"lamp": "on"}, "reason": null, "command": {"lamp.cmd": null}}
{"cycle": 8, "time": 4, "delta": true, "observations": {"lamp.light": null}}
)");
  const auto lines = read_log(in, "in.jsonl", lamp());
  ASSERT_EQ(lines.size(), 3U);  // what comes before the first whole line rests on nothing
  EXPECT_EQ(lines[1].unchanged, 2U);
  EXPECT_TRUE(lines[1].command.empty());
  EXPECT_EQ(lines[1].observations, lines[0].observations);
  EXPECT_EQ(lines[1].estimate, (std::vector<Assignment>{{VariableId(0), ValueId(1)}}));
  EXPECT_EQ(lines[2].unchanged, 0U);
  EXPECT_TRUE(lines[2].observations.empty());
  EXPECT_EQ(lines[2].estimate, lines[1].estimate);
  EXPECT_EQ(error_of("{}\n{\"delta\": 1}"), "in.jsonl:2: 'delta': expected true or false, not 1");
  EXPECT_EQ(error_of("{}\n{\"delta\": true, \"observations\": {\"lamp.ligth\": null}}"),
            "in.jsonl:2: 'observations': there is no 'lamp.ligth' that could be gone");
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
