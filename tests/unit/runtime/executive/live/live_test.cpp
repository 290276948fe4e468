// A live plant: lines in bounded memory, answers read strictly, and a day of whatever can go wrong.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "runtime/executive/live/run.hpp"
#include "runtime/executive/trace/trace_writer.hpp"
#include "tests/unit/runtime/executive/cycle/heater.hpp"
#include "tests/unit/runtime/executive/live/mad_plant.hpp"

namespace rmpl::runtime {
namespace {

using namespace rmpl::automata;
using testing::HasSubstr;

TEST(Inbox, CutsLinesWhereverTheBytesAreCut) {
  Inbox inbox;
  inbox.add("one\ntw");
  EXPECT_EQ(inbox.next()->text, "one");
  EXPECT_FALSE(inbox.next());
  EXPECT_TRUE(inbox.begun());
  inbox.add("o\n\n");
  EXPECT_EQ(inbox.next()->text, "two");
  EXPECT_EQ(inbox.next()->text, "");
  EXPECT_FALSE(inbox.next());
  EXPECT_FALSE(inbox.begun());
}

TEST(Inbox, KeepsNothingOfALineThatIsTooLong) {
  Inbox inbox;
  for (int i = 0; i < 100; ++i) {
    inbox.add(std::string(10'000, 'x'));
    EXPECT_FALSE(inbox.next());
  }
  EXPECT_TRUE(inbox.begun());
  inbox.add("x\nshort\n");
  EXPECT_TRUE(inbox.next()->too_long);
  const auto line = inbox.next();
  EXPECT_FALSE(line->too_long);
  EXPECT_EQ(line->text, "short");
}

std::string complaint(const std::string& text) {
  const Plant plant = heater::plant();
  Answers answers(plant, 3, nullptr);
  answers.skip();
  try {
    answers.read({text, false});
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Answers, AreReadStrictlyAndLocated) {
  EXPECT_EQ(complaint(R"({"cycle":7,"observations":{"heater.temp":"low"}})"), "");
  EXPECT_THAT(complaint("{"), HasSubstr("plant 3:2:2: not JSON"));
  EXPECT_THAT(complaint(""), HasSubstr("plant 3:2: expected a JSON object, found nothing"));
  EXPECT_THAT(complaint("{}"), HasSubstr("plant 3:2: expected 'cycle'"));
  EXPECT_THAT(complaint(R"({"cycle":-1})"), HasSubstr("'cycle': expected a whole number"));
  EXPECT_THAT(complaint(R"({"cycle":1,"observations":{"heater.tmp":"low"}})"), HasSubstr("'heater.temp'"));
  EXPECT_THAT(complaint(R"({"cycle":1,"observations":{"heater":"on"}})"), HasSubstr("no sensor reads its mode"));
  EXPECT_THAT(complaint(std::string("{\"cycle\":1}\0", 12)), HasSubstr("NUL"));
  EXPECT_LT(complaint("{\"" + std::string(60'000, 'k') + "\":1}").size(), 300U);
}

/// What the executive did with a day of a mad plant, cycle by cycle.
class Auditor final : public CycleObserver {
 public:
  explicit Auditor(MadPlant& plant) : plant_(plant) {}

  void observe(const CycleRecord& record) override {
    plant_.asked_ = record.cycle + 1;
    if (record.cycle == 0) return;
    ++cycles;
    bool lost = false, flooded = false;
    for (const Event& event : record.events) {
      ++events[event.kind];
      lost = lost || event.kind == Event::Kind::unacknowledged;
      flooded = flooded || event.kind == Event::Kind::flood;
      EXPECT_FALSE(event.message.empty());
      EXPECT_LT(event.message.size(), 400U);
    }
    const bool answered = plant_.in_time.count(record.cycle) > 0;
    if (!flooded) {  // what comes behind a flood is not read
      EXPECT_EQ(lost, !answered) << "cycle " << record.cycle;
    }
    EXPECT_TRUE(lost || answered) << "cycle " << record.cycle;
    if (answered) {
      EXPECT_TRUE(plant_.heard.count(record.cycle) > 0) << "cycle " << record.cycle;
    }
    if (lost) {
      EXPECT_TRUE(record.observations.empty()) << "cycle " << record.cycle;
    }
  }

  std::uint64_t cycles = 0;
  std::map<Event::Kind, std::uint64_t> events;

 private:
  MadPlant& plant_;
};

constexpr Ticks a_second = Ticks::of_seconds(1);

std::string day(std::uint64_t seed, LiveOptions::Time time, Ticks duration, Auditor* auditor, MadPlant& plant) {
  const Program program = heater::program(true);
  const Plant model = heater::plant();
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) /
                                     ("rmpl-day-" + std::to_string(::getpid()) + "-" + std::to_string(seed));
  LiveRun run;
  run.cycle = a_second;
  run.duration = duration;
  run.plant.time = time;
  run.plant.patience = a_second;
  run.engines.engine = ScenarioOptions::Engine::exact;
  TraceWriter trace(model, program, path.string(), TraceDetail::cycles);
  std::vector<CycleObserver*> observers{&trace};
  if (auditor != nullptr) observers.push_back(auditor);
  Engines engines(model, run.engines, run.cycle);
  const LiveResult result = run_live(program, engines, plant, run, observers);
  EXPECT_EQ(result.end, LiveResult::End::duration);
  trace.keep();
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  std::filesystem::remove(path);
  return text.str();
}

TEST(LivePlant, ADayOfAbuseLosesNoCommandUntold) {
  MadPlant plant(16, a_second);
  Auditor auditor(plant);
  const std::string trace = day(16, LiveOptions::Time::wall, Ticks::of_seconds(24L * 3600), &auditor, plant);
  EXPECT_EQ(auditor.cycles, 24U * 3600);
  EXPECT_EQ(std::count(trace.begin(), trace.end(), '\n'), 24 * 3600 + 1);
  for (const Event::Kind kind : {Event::Kind::connected, Event::Kind::gone, Event::Kind::refused, Event::Kind::late,
                                 Event::Kind::flood, Event::Kind::unacknowledged}) {
    EXPECT_GT(auditor.events[kind], 100U) << name_of(kind);
  }
  EXPECT_EQ(auditor.events[Event::Kind::connected], plant.comings);
  EXPECT_GT(plant.in_time.size(), auditor.cycles / 2);
}

TEST(LivePlant, TheSameSeedIsTheSameTrace) {
  for (const auto time : {LiveOptions::Time::wall, LiveOptions::Time::lock_step}) {
    MadPlant plant(7, a_second), again(7, a_second), other(8, a_second);
    const std::string trace = day(7, time, Ticks::of_seconds(3600), nullptr, plant);
    EXPECT_EQ(trace, day(7, time, Ticks::of_seconds(3600), nullptr, again));
    EXPECT_NE(trace, day(8, time, Ticks::of_seconds(3600), nullptr, other));
  }
}

}  // namespace
}  // namespace rmpl::runtime
