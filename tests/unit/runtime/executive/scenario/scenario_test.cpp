// Scenarios: verdicts with their times and reasons, the end of a run, the story, the trace as a log.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "runtime/executive/scenario/moment.hpp"
#include "runtime/executive/scenario/report.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/executive/scenario/story.hpp"
#include "runtime/executive/sequence/log_run.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/executive/trace/trace_writer.hpp"
#include "tests/unit/runtime/executive/cycle/heater.hpp"

namespace rmpl::runtime {
namespace {

using namespace rmpl::automata;
using namespace heater;
using Kind = Expectation::Kind;
using Verdict = Judgement::Verdict;

ScenarioResult fly(const Scenario& scenario, const Document& document = heater::document(),
                   std::vector<CycleObserver*> observers = {}) {
  return run_scenario(document, scenario, {}, observers);
}

TEST(Scenario, EndsWithTheProgramWhenAllIsDecided) {
  Scenario scenario = heater::scenario();
  scenario.expectations = {expects(Kind::finished), expects(Kind::eventually, is(mode, ValueId(on.index()))),
                           expects(Kind::never, is(mode, ValueId(broken.index())))};
  scenario.expectations[0].within = Ticks::of_seconds(3);
  const ScenarioResult result = fly(scenario);
  EXPECT_EQ(result.verdict(), Verdict::met);
  EXPECT_EQ(result.cycles, 5U);
  EXPECT_EQ(result.ended, (Ticks{2'500'000'000}));
  for (const Judgement& judgement : result.judgements) EXPECT_EQ(judgement.time, (Ticks{2'500'000'000}));
}

// The mode that is off at first is on where the program ends.
TEST(Scenario, WhatAProgramIsToEndWithIsAskedThen) {
  Scenario scenario = heater::scenario();
  scenario.expectations = {expects(Kind::finished, is(mode, ValueId(on.index()))),
                           expects(Kind::finished, is(mode, ValueId(off.index()))), expects(Kind::no_plan),
                           expects(Kind::goal_conflict)};
  const ScenarioResult result = fly(scenario);
  EXPECT_EQ(result.judgements[0].verdict, Verdict::met);
  EXPECT_EQ(result.judgements[1].verdict, Verdict::failed);
  EXPECT_EQ(result.judgements[1].time, (Ticks{2'500'000'000}));
  EXPECT_EQ(result.judgements[2].verdict, Verdict::met);
  EXPECT_EQ(result.judgements[3].verdict, Verdict::met);
}

// It ends at 2.5 s, with the mode on.
TEST(Scenario, WhatIsToGoOnFailsAsItEnds) {
  Scenario scenario = heater::scenario();
  scenario.expectations = {expects(Kind::never_finished), expects(Kind::never_finished, is(mode, ValueId(on.index()))),
                           expects(Kind::never_finished, is(mode, ValueId(off.index()))), expects(Kind::never_finished),
                           expects(Kind::never_finished)};
  scenario.expectations[3].within = Ticks::of_seconds(2);
  scenario.expectations[4].within = Ticks{2'500'000'000};
  const ScenarioResult result = fly(scenario);
  const std::vector<Verdict> verdicts = {Verdict::failed, Verdict::failed, Verdict::met, Verdict::met, Verdict::failed};
  for (std::size_t i = 0; i < verdicts.size(); ++i) EXPECT_EQ(result.judgements[i].verdict, verdicts[i]) << i;
  EXPECT_EQ(result.judgements[0].reason, "the program ended");
  EXPECT_EQ(result.judgements[0].time, (Ticks{2'500'000'000}));
  EXPECT_EQ(result.judgements[3].time, Ticks::of_seconds(2));
  scenario.duration = Ticks::of_seconds(2);
  EXPECT_EQ(fly(scenario).verdict(), Verdict::met);
}

TEST(Scenario, TimesAreExact) {
  Scenario scenario = heater::scenario();
  Expectation warm = expects(Kind::eventually, is(temp, high));
  warm.after = is(mode, ValueId(heating.index()));
  warm.within = Ticks::of_seconds(2);
  Expectation sooner = warm;
  sooner.within = Ticks{1'999'999'999};
  scenario.expectations = {warm, sooner};
  const ScenarioResult result = fly(scenario);
  EXPECT_EQ(result.judgements[0].verdict, Verdict::met);
  EXPECT_EQ(result.judgements[0].time, (Ticks{2'500'000'000}));
  EXPECT_EQ(result.judgements[1].verdict, Verdict::failed);
  EXPECT_EQ(result.judgements[1].reason, "not by 2.499999999 s");
  EXPECT_EQ(result.verdict(), Verdict::failed);
}

TEST(Scenario, TimeEnds) {
  Scenario scenario = heater::scenario();
  scenario.cycle = Ticks::of_seconds(30'000 * std::int64_t{86'400});
  scenario.duration = Ticks::of_seconds(100'000 * std::int64_t{86'400});
  try {
    fly(scenario, heater::document(true));
    FAIL() << "flew beyond the end of time";
  } catch (const base::InputError& error) {
    EXPECT_STREQ(error.what(),
                 "time ends 9223372036.854775806 s after the start, and cycle 4 of 2592000000 s would end later; "
                 "expected a shorter duration");
  }
}

TEST(Scenario, WhatMayTakeLongerThanTimeLastsHasNoDeadline) {
  Scenario scenario = heater::scenario();
  Expectation late = expects(Kind::eventually, is(mode, ValueId(on.index())));
  late.after = is(mode, ValueId(heating.index()));
  late.within = Ticks{Ticks::infinite().count - 1};
  scenario.expectations = {late};
  EXPECT_EQ(fly(scenario).judgements[0].time, (Ticks{2'500'000'000}));
}

TEST(Scenario, TheTruthIsNotTheEstimate) {
  Scenario scenario = heater::scenario();
  scenario.truth = {in(on)};
  Expectation truth = expects(Kind::never, is(mode, ValueId(off.index())));
  truth.truth = true;
  scenario.expectations = {truth, expects(Kind::never, is(mode, ValueId(off.index())))};
  const ScenarioResult result = fly(scenario);
  EXPECT_EQ(result.judgements[0].verdict, Verdict::met);
  EXPECT_EQ(result.judgements[1].verdict, Verdict::failed);
  EXPECT_EQ(result.judgements[1].time, Ticks{});
}

TEST(Scenario, ItsDurationEndsARunThatHasNoEnd) {
  Scenario scenario = heater::scenario();
  scenario.expectations = {expects(Kind::finished), expects(Kind::never, is(mode, ValueId(broken.index())))};
  const ScenarioResult result = fly(scenario, heater::document(true));
  EXPECT_EQ(result.time, Ticks::of_seconds(20));
  EXPECT_FALSE(result.ended);
  EXPECT_EQ(result.judgements[0].verdict, Verdict::failed);
  EXPECT_EQ(result.judgements[1].verdict, Verdict::met);
}

// A fault that lies ahead may still violate a `never`.
TEST(Scenario, GoesOnAfterTheProgramWhileSomethingIsInStore) {
  Scenario scenario = heater::scenario();
  scenario.forced = {{Ticks::of_seconds(10), component, broken, {}}};
  EXPECT_EQ(fly(scenario).time, (Ticks{2'500'000'000}));
  scenario.expectations = {expects(Kind::never, is(mode, ValueId(broken.index())))};
  const ScenarioResult result = fly(scenario);
  EXPECT_EQ(result.judgements[0].verdict, Verdict::failed);
  EXPECT_EQ(result.judgements[0].time, Ticks::of_seconds(10));
  EXPECT_EQ(result.time, Ticks::of_seconds(10));
}

TEST(Scenario, AnInterruptedRunIsUndecided) {
  Scenario scenario = heater::scenario();
  scenario.expectations = {expects(Kind::eventually, is(mode, ValueId(on.index())))};
  ScenarioOptions options;
  int cycles = 0;
  options.interrupted = [&cycles] { return ++cycles > 2; };
  const ScenarioResult result = run_scenario(heater::document(), scenario, options, {});
  EXPECT_TRUE(result.interrupted);
  EXPECT_EQ(result.cycles, 2U);
  EXPECT_EQ(result.verdict(), Verdict::undecided);
  EXPECT_EQ(result.judgements[0].reason, "the run was interrupted at 1 s");
}

TEST(Scenario, RulesHaveNoTruthToSpeakOf) {
  Scenario scenario = heater::scenario();
  scenario.rules_only = true;
  scenario.expectations = {expects(Kind::never, constant(false))};
  scenario.expectations[0].truth = true;
  EXPECT_THROW(fly(scenario), base::InputError);
}

TEST(Story, TellsWhatChanges) {
  Scenario scenario = heater::scenario();
  scenario.forced = {{Ticks::of_seconds(1), component, broken, {}}};
  const Document document = heater::document();
  std::string story;
  Story teller(document.plants[0], document.programs[0], MomentColumn(scenario.duration, scenario.cycle), {}, {},
               [&](const std::string& line) { story += line + "\n"; });
  fly(scenario, document, {&teller});
  EXPECT_EQ(story.substr(0, story.find("fault")),
            "     0 s  goal      + heater = on\n"
            "     0 s  command   heater.cmd = on for heater = on, 'heater' to 'on': 'heater' from 'off' to 'heating'\n"
            "   0.5 s  estimate  heater: off -> heating\n"
            "   0.5 s  wait      for heater = on: 'heater' from 'heating' to 'on'\n"
            "     1 s  plant     heater = broken (the executive is not told)\n"
            "   2.5 s  ");
}

TEST(Story, KeepsToItsFocus) {
  const Document document = heater::document();
  const auto told = [&](const StoryFocus& focus) {
    std::vector<std::string> lines;
    Story teller(document.plants[0], document.programs[0], MomentColumn({}, {}), {}, focus,
                 [&](const std::string& line) { lines.push_back(line); });
    fly(heater::scenario(), document, {&teller});
    return lines;
  };
  EXPECT_EQ(told({}), told({{component}, {}, Ticks::infinite()}));
  EXPECT_EQ(told({{ComponentId(7)}, {}, Ticks::infinite()}), std::vector<std::string>{});
  EXPECT_EQ(told({{}, Ticks{2'500'000'000}, Ticks{2'500'000'000}}),
            std::vector<std::string>{"  2.5 s  estimate  heater: heating -> on"});
}

/// What is commanded, cycle by cycle, to an actuator that starts when it likes.
TEST(Story, ACommandThatGoesOnIsToldAgainOnce) {
  const Document document = heater::document();
  std::string story;
  Story teller(document.plants[0], document.programs[0], MomentColumn({}, {}), {}, {},
               [&](const std::string& line) { story += line + "\n"; });
  CycleRecord record;
  record.estimate = {off};
  for (const ValueId command : {none, turn_on, turn_on, turn_on, none, turn_on, turn_off}) {
    record.start = record.time;
    record.time = Ticks::of_seconds(static_cast<std::int64_t>(record.cycle));
    record.command = {command};
    teller.observe(record);
    ++record.cycle;
  }
  EXPECT_EQ(story,
            "  0 s  command   heater.cmd = on\n"
            "  1 s  command   heater.cmd = on (again)\n"
            "  4 s  command   heater.cmd = on\n"
            "  5 s  command   heater.cmd = off\n");
}

TEST(Moment, IsInSecondsAndFromAMinuteOnInHours) {
  EXPECT_EQ(moment(Ticks{43'500'000'000}), "43.5 s");
  EXPECT_EQ(moment(Ticks::of_seconds(60)), "60 s (0:01:00)");
  EXPECT_EQ(moment(Ticks{16'244'500'000'000}), "16244.5 s (4:30:44.5)");
  const MomentColumn column(Ticks::of_seconds(18'000), Ticks{Ticks::per_second / 2});
  EXPECT_EQ(column.text(Ticks{}), "      0 s           ");
  EXPECT_EQ(column.text(Ticks{16'244'500'000'000}), "16244.5 s  4:30:44.5");
  EXPECT_EQ(column.text(Ticks::of_seconds(3600)), "   3600 s    1:00:00");
}

TEST(Scenario, WhatFailsSaysWhatWasTheCase) {
  Scenario scenario = heater::scenario();
  scenario.expectations = {expects(Kind::never, is(mode, ValueId(heating.index()))),
                           expects(Kind::eventually, is(mode, ValueId(broken.index()))), expects(Kind::finished)};
  scenario.expectations[2].within = Ticks::of_seconds(1);
  const ScenarioResult result = fly(scenario);
  EXPECT_EQ(result.judgements[0].evidence,
            "heater = heating, heater.temp = low; cycle 1: heater.cmd = on for heater = on, 'heater' to 'on': 'heater' "
            "from 'off' to 'heating'");
  EXPECT_EQ(result.judgements[1].evidence, "heater = on, heater.temp = high; cycle 40");
  EXPECT_EQ(result.judgements[2].reason, "not by 1 s");
}

TEST(Report, JsonHasTheVerdictsAndNothingThatChanges) {
  Scenario scenario = heater::scenario();
  scenario.expectations = {expects(Kind::finished)};
  JsonLine first, second;
  write_result(first, scenario, fly(scenario));
  write_result(second, scenario, fly(scenario));
  EXPECT_EQ(first.text(), second.text());
  EXPECT_EQ(first.text(), R"({"scenario":"warm up","verdict":"met","seed":0,"cycles":5,"time":2.5,"ended":2.5,)"
                          R"("expectations":[{"text":"…","verdict":"met","time":2.5,"file":"","line":0}]})");
}

/// A directory of one's own.
class TraceFile : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(directory_); }
  void TearDown() override { std::filesystem::remove_all(directory_); }
  [[nodiscard]] std::string path() const { return (directory_ / "out.jsonl").string(); }
  /// Flies, and answers the lines of the trace.
  std::vector<nlohmann::json> fly_and_read(const Scenario& scenario, const Document& document, TraceDetail detail) {
    TraceWriter trace(document.plants[0], document.programs[0], path(), detail);
    fly(scenario, document, {&trace});
    trace.keep();
    std::ifstream file(path());
    std::vector<nlohmann::json> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(nlohmann::json::parse(line));
    return lines;
  }
  std::filesystem::path directory_ =
      std::filesystem::path(::testing::TempDir()) / ("rmpl-trace-test-" + std::to_string(::getpid()));
};

TEST_F(TraceFile, RepeatsAsALogOfTheSequencer) {
  const Document document = heater::document();
  const auto lines = fly_and_read(heater::scenario(), document, TraceDetail::beliefs);
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[0]["cycle"], 0);
  EXPECT_EQ(lines[1]["time"], 0.5);
  EXPECT_EQ(lines[1]["command"], nlohmann::json({{"heater.cmd", "on"}}));
  EXPECT_EQ(lines[1]["belief"][0]["modes"]["heater"], "heating");
  EXPECT_EQ(lines[5]["truth"], nlohmann::json({{"heater", "on"}}));

  std::ifstream log(path());
  std::stringstream sequence;
  sequence_log(document.programs[0], document.plants[0], log, "out.jsonl",
               [&sequence](std::string_view line) { sequence << line << '\n'; });
  std::size_t cycle = 0;
  for (std::string line; std::getline(sequence, line);) {
    const auto repeated = nlohmann::json::parse(line);
    ++cycle;
    EXPECT_EQ(repeated["marking"], lines[cycle]["marking"]);
    EXPECT_EQ(repeated["goal"], lines[cycle]["goal"]);
  }
  EXPECT_EQ(cycle, 5U);
}

// What a small trace leaves out is what was the case before: read as a log it is the whole flight.
TEST_F(TraceFile, OfChangesIsTheSameLogAsThatOfAllCycles) {
  const Document document = heater::document(true);
  Scenario scenario = heater::scenario();
  scenario.forced = {{Ticks::of_seconds(5), component, broken, {}}};
  std::vector<std::string> repeated;
  std::vector<std::size_t> lengths;
  for (const TraceDetail detail : {TraceDetail::changes, TraceDetail::cycles, TraceDetail::beliefs}) {
    const auto lines = fly_and_read(scenario, document, detail);
    lengths.push_back(lines.size());
    EXPECT_EQ(lines.back()["cycle"], 40);
    EXPECT_EQ(lines.back()["time"], 20);
    EXPECT_EQ(lines.back().contains("belief"), detail == TraceDetail::beliefs);
    std::ifstream whole(path());
    std::uint64_t cycles = 0;
    for (const LogLine& line : read_log(whole, "out.jsonl", document.plants[0])) cycles += 1 + line.unchanged;
    EXPECT_EQ(cycles, 41U);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      EXPECT_EQ(lines[i].contains("delta"), detail == TraceDetail::changes && i > 0);
    }
    std::ifstream log(path());
    std::string& sequence = repeated.emplace_back();
    sequence_log(document.programs[0], document.plants[0], log, "out.jsonl",
                 [&sequence](std::string_view line) { sequence.append(line).push_back('\n'); });
  }
  EXPECT_EQ(repeated[0], repeated[1]);
  EXPECT_EQ(repeated[1], repeated[2]);
  EXPECT_LT(lengths[0], 15U);
  EXPECT_EQ(lengths[1], 41U);
  EXPECT_EQ(lengths[2], 41U);
}

TEST_F(TraceFile, IsNotLeftBehindByARunThatFails) {
  const Document document = heater::document();
  { const TraceWriter trace(document.plants[0], document.programs[0], path()); }
  EXPECT_FALSE(std::filesystem::exists(path()));
}

}  // namespace
}  // namespace rmpl::runtime
