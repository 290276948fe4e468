// Traces of random flights: whatever their detail, read as logs they are the same flight; what they print as the
// evidence of a diagnosis refutes.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/executive/sequence/log_run.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/executive/trace/trace_writer.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/parts.hpp"

namespace rmpl::property {
namespace {

using runtime::TraceDetail;

/// A cycle of a log, with those that a line left out.
struct LoggedCycle {
  automata::Ticks time;
  runtime::LogLine told;
};

std::vector<LoggedCycle> cycles_of(const std::vector<runtime::LogLine>& lines) {
  std::vector<LoggedCycle> cycles;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::uint64_t c = 1; c <= lines[i].unchanged; ++c) {
      cycles.push_back({lines[i].time_of_unchanged(c), lines[i - 1]});
    }
    cycles.push_back({lines[i].time, lines[i]});
  }
  return cycles;
}

struct Flight {
  std::vector<LoggedCycle> cycles;
  std::string sequence;
  std::vector<nlohmann::json> lines;
};

Flight fly(const automata::Document& document, TraceDetail detail, std::uint64_t keyframe = 1) {
  const std::string path =
      (std::filesystem::path(::testing::TempDir()) / ("rmpl-trace-" + std::to_string(::getpid()) + ".jsonl")).string();
  runtime::TraceWriter trace(document.plants[0], document.programs[0], path, detail, keyframe);
  runtime::ScenarioOptions options;
  options.engine = runtime::ScenarioOptions::Engine::exact;
  run_scenario(document, document.scenarios[0], options, {&trace});
  trace.keep();
  Flight flight;
  std::ifstream log(path);
  flight.cycles = cycles_of(runtime::read_log(log, "trace", document.plants[0]));
  std::ifstream again(path);
  runtime::sequence_log(document.programs[0], document.plants[0], again, "trace",
                        [&flight](std::string_view line) { flight.sequence.append(line).push_back('\n'); });
  std::ifstream lines(path);
  for (std::string line; std::getline(lines, line);) flight.lines.push_back(nlohmann::json::parse(line));
  std::filesystem::remove(path);
  return flight;
}

/// The estimates that the cycles of a log lead to are those that the executive had.
void repeat(const automata::Plant& plant, const std::vector<LoggedCycle>& cycles) {
  automata::PlantStep step(plant);
  runtime::EstimatorOptions options;
  options.live_clocks_only = true;
  const auto estimator = runtime::make_exact_estimator(step, options);
  for (std::size_t i = 1; i < cycles.size(); ++i) {
    const runtime::LogLine& told = cycles[i].told;
    estimator->update(automata::action_from(plant, told.command), told.observations, cycles[i].time);
    RC_ASSERT(automata::assignments_of(plant, estimator->estimate().modes) == *told.estimate);
  }
}

automata::Document draw_flight() {
  const Model model = *models({.open = chance(50)});
  automata::Document document;
  document.plants.push_back(model.plant);
  document.programs.push_back((chance(50) ? *programs_that_know(model.plant) : *programs(model.plant)).program);
  automata::Scenario& scenario = document.scenarios.emplace_back();
  scenario.name = "random";
  scenario.cycle = automata::Ticks{automata::Ticks::per_second / 2};
  scenario.duration = automata::Ticks::of_seconds(*rc::gen::inRange(1, 12));
  scenario.seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
  return document;
}

/// What printed evidence lists, as formulas.
std::vector<automata::Formula> parts_of(const nlohmann::json& evidence, const automata::Plant& plant) {
  std::vector<automata::Formula> parts;
  for (const auto& [name, value] : evidence["readings"].items()) {
    const automata::VariableId variable = *plant.variables.find(name);
    parts.push_back(automata::is(variable, *plant.variables[variable].find(value.get<std::string>())));
  }
  for (const auto& printed : evidence["modes"]) {
    const automata::Component& component = plant[*plant.find_component(printed["component"].get<std::string>())];
    const auto mode = std::find_if(component.modes.begin(), component.modes.end(),
                                   [&](const automata::Mode& m) { return m.name == printed["mode"]; });
    RC_ASSERT(mode != component.modes.end());
    const auto value = automata::ValueId(static_cast<std::size_t>(mode - component.modes.begin()));
    parts.push_back(automata::conjunction({automata::is(component.mode, value), mode->constraint}));
  }
  for (const auto& printed : evidence["interconnections"]) {
    parts.push_back(plant.interconnections[printed["number"].get<std::size_t>() - 1].constraint);
  }
  return parts;
}

RC_GTEST_PROP(Traces, PrintEvidenceThatRefutesAndOfWhichNothingCanBeSpared, ()) {
  const automata::Document document = draw_flight();
  const automata::Plant& plant = document.plants[0];
  try {
    for (const nlohmann::json& line : fly(document, TraceDetail::changes).lines) {
      if (!line.contains("evidence")) continue;
      for (const nlohmann::json& evidence : line["evidence"]) {
        RC_TAG(evidence["kind"].get<std::string>());
        RC_ASSERT(line["estimate"][evidence["component"].get<std::string>()] == evidence["fault"]);
        RC_ASSERT(evidence["story"].contains(evidence["component"].get<std::string>()) ==
                  (evidence["kind"] != "unavoidable"));
        for (const auto& [name, value] : evidence["readings"].items()) RC_ASSERT(line["observations"][name] == value);
        if (evidence["kind"] != "refuted") continue;
        const auto parts = parts_of(evidence, plant);
        RC_ASSERT(!consistent(plant, parts, parts.size()));
        for (std::size_t i = 0; i < parts.size(); ++i) RC_ASSERT(consistent(plant, parts, i));
      }
    }
  } catch (const base::InputError&) {
    RC_DISCARD("the simulated plant is left without a state");
  }
}

RC_GTEST_PROP(Traces, OfEveryDetailAreTheSameLog, ()) {
  const automata::Document document = draw_flight();
  try {
    const Flight changes = fly(document, TraceDetail::changes, up_to(1, 6));
    const Flight every = fly(document, TraceDetail::cycles);
    const Flight beliefs = fly(document, TraceDetail::beliefs);
    RC_ASSERT(changes.sequence == every.sequence);
    RC_ASSERT(every.sequence == beliefs.sequence);
    RC_ASSERT(changes.cycles.size() == every.cycles.size());
    for (std::size_t i = 0; i < every.cycles.size(); ++i) {
      RC_ASSERT(changes.cycles[i].time == every.cycles[i].time);
      RC_ASSERT(changes.cycles[i].told.command == every.cycles[i].told.command);
      RC_ASSERT(changes.cycles[i].told.observations == every.cycles[i].told.observations);
      RC_ASSERT(changes.cycles[i].told.estimate == every.cycles[i].told.estimate);
    }
    repeat(document.plants[0], changes.cycles);
  } catch (const base::InputError&) {
    RC_DISCARD("the simulated plant is left without a state");
  }
}

}  // namespace
}  // namespace rmpl::property
