// Sessions on random plants: they are the flight of their scenario, and what comes was shown as what may come.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "runtime/executive/step/flight_steps.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/engineered.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;
using runtime::FlightSteps;
using runtime::Prospect;

/// A program that asserts the goal for ever.
automata::Document document_of(const Engineered& engineered) {
  automata::Document document;
  document.plants = {engineered.plant};
  automata::Program program;
  program.name = "Hold";
  program.variables = engineered.plant.variables;
  program.locations.resize(2);
  program.locations[0].composite = true;
  program.locations[0].start = true;
  automata::Location& hold = program.locations[1];
  hold.parent = automata::LocationId(0);
  hold.start = true;
  hold.goal_constraints = {engineered.goal};
  hold.arcs.push_back({{}, automata::LocationId(1)});
  document.programs = {program};
  return document;
}

automata::Scenario scenario_of(const Engineered& engineered) {
  automata::Scenario scenario;
  scenario.name = "stepped";
  scenario.cycle = Ticks{Ticks::per_second / static_cast<std::int64_t>(up_to(1, 2))};
  scenario.duration = Ticks::of_seconds(static_cast<std::int64_t>(up_to(1, 12)));
  scenario.seed = up_to(0, 1000);
  for (std::size_t c = 0; c < engineered.start.size(); ++c) {
    scenario.truth.push_back({engineered.plant.components[c].mode, automata::ValueId(engineered.start[c].index())});
  }
  return scenario;
}

struct Seen {
  Ticks time;
  automata::Modes truth, estimate;
  automata::ControlAction command;
  automata::Observation observations;
  bool operator==(const Seen&) const = default;
};

Seen seen(const runtime::CycleRecord& record) {
  return {record.time, *record.truth, record.estimate, record.command, record.observations};
}

class Recorder final : public runtime::CycleObserver {
 public:
  void observe(const runtime::CycleRecord& record) override { cycles.push_back(seen(record)); }
  std::vector<Seen> cycles;
};

/// Chooses something that may come, now and then.
void choose(FlightSteps& steps) {
  std::vector<Prospect> open = steps.ahead();
  std::erase_if(open, [](const Prospect& one) { return !can_be_chosen(one); });
  if (open.empty() || chance(50)) return;
  const Prospect chosen = pick(open);
  if (chosen.component) {
    steps.force(*chosen.component, automata::ModeId(chosen.what.value.index()));
  } else {
    steps.command(chosen.what);
  }
}

/// What a component is in after a step was among what might come, or it stays where nothing else was shown.
void check_shown(const automata::Plant& plant, const std::vector<Prospect>& ahead, const automata::Modes& before,
                 const automata::Modes& after) {
  for (std::size_t c = 0; c < after.size(); ++c) {
    if (before[c] == after[c]) continue;
    const automata::Assignment came{plant.components[c].mode, automata::ValueId(after[c].index())};
    RC_ASSERT(std::any_of(ahead.begin(), ahead.end(), [&](const Prospect& one) {
      return one.component && one.what == came && one.probability > 0;
    }));
  }
}

RC_GTEST_PROP(Steps, AreTheFlightOfTheirScenario, ()) {
  const Engineered drawn = *engineered(2, 4);
  const automata::Document document = document_of(drawn);
  const automata::Scenario scenario = scenario_of(drawn);
  runtime::ScenarioOptions options;
  try {
    FlightSteps steps(document, scenario, options);
    std::vector<Seen> cycles{seen(steps.last())};
    for (std::size_t moves = up_to(1, 14); moves > 0; --moves) {
      if (steps.position() > 0 && chance(25)) {
        const std::uint64_t back = up_to(0, steps.position() - 1);
        steps.go_back_to(back);
        cycles.resize(back + 1);
        RC_ASSERT(seen(steps.last()) == cycles.back());
        continue;
      }
      choose(steps);
      const automata::Modes before = *steps.last().truth;
      const std::vector<Prospect> ahead = steps.ahead();
      if (!steps.advance(nullptr)) break;
      check_shown(document.plants[0], ahead, before, *steps.last().truth);
      cycles.push_back(seen(steps.last()));
    }
    Recorder recorder;
    automata::Scenario flown = steps.scenario();
    if (steps.position() == 0) return;
    flown.duration = steps.time();
    run_scenario(document, flown, options, {&recorder});
    RC_ASSERT(recorder.cycles == cycles);
    RC_TAG(steps.choices().empty() ? "nothing chosen" : "chosen");
  } catch (const base::InputError&) {
    RC_DISCARD("nothing consistent can follow");
  }
}

}  // namespace
}  // namespace rmpl::property
