// Fuzzes what follows a text that compiles: flights, estimates, plans and checks, each within small limits. Two engines
// that must agree are asked where there are two.
//
// The input is a file of each kind, in the order program, plant, scenario, and as a fourth, where there is one, what
// the others import as `software.rmpl`; parted by lines `====`. SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "automata/json/document.hpp"
#include "automata/step/plant_step.hpp"
#include "base/check.hpp"
#include "base/error.hpp"
#include "base/limit_error.hpp"
#include "compiler/session/compiler.hpp"
#include "compiler/session/provider.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "verifier/check/check.hpp"
#include "verifier/closed_loop/check.hpp"
#include "verifier/property/initial_modes.hpp"

using namespace rmpl;

namespace {

/// A mutation can make any model: what is larger would only cost time.
constexpr std::size_t most_components = 8;
constexpr std::size_t most_locations = 40;
constexpr std::size_t most_states = 300;
constexpr std::uint64_t most_cycles = 60;

std::vector<std::string> parts_of(std::string_view text) {
  constexpr std::string_view line = "\n====\n";
  std::vector<std::string> parts;
  for (std::size_t end = text.find(line); end != std::string_view::npos; end = text.find(line)) {
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(end + line.size());
  }
  parts.emplace_back(text);
  return parts;
}

verifier::Limits small_limits() {
  verifier::Limits limits;
  limits.states = most_states;
  limits.time = std::chrono::seconds(2);
  return limits;
}

void check_plant(const automata::Plant& plant) {
  verifier::Slices slices(plant);
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const automata::Component& component = plant.components[c];
    const auto last = automata::ValueId(component.modes.size() - 1);
    verifier::CheckOptions options;
    options.faults = 1;
    const verifier::Property property = verifier::Reachability{automata::is(component.mode, last), {}, false};
    const verifier::Answer with = verifier::check(slices, property, options, small_limits());
    options.symmetry = false;
    const verifier::Answer without = verifier::check(slices, property, options, small_limits());
    if (with.limit || without.limit) continue;
    CHECK(with.verdict == without.verdict && "no verdict depends on symmetry");
  }
  (void)verifier::check(slices, verifier::Stuck{}, {}, small_limits());
}

void check_program(const automata::Program& program, const automata::Plant& plant) {
  automata::PlantStep step(plant);
  std::vector<verifier::Property> properties;
  for (const auto kind : verifier::general_kinds) properties.emplace_back(verifier::ProgramProperty{kind});
  verifier::CheckOptions options;
  options.faults = 1;
  (void)verifier::check(program, step, properties, options, small_limits());
}

/// From the first modes that are possible for each component to each mode of each.
void plan(const automata::Plant& plant) {
  automata::PlantStep step(plant);
  const auto reconfigurer = runtime::make_reconfigurer(step);
  automata::Modes start;
  for (const auto& modes : verifier::initial_modes(plant, {})) start.push_back(modes.front());
  if (!step.possible(start)) return;
  for (const automata::Component& component : plant.components) {
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const auto answer = reconfigurer->next(start, automata::is(component.mode, automata::ValueId(m)));
      CHECK((answer.outcome != runtime::Reconfiguration::Outcome::no_plan || !answer.reason.empty()) &&
            "no plan without a reason");
    }
  }
}

void fly(const automata::Document& document) {
  for (automata::Scenario scenario : document.scenarios) {
    const auto most = static_cast<std::int64_t>(most_cycles);
    if (scenario.cycle.count > automata::Ticks::infinite().count / most) continue;
    scenario.duration = std::min(scenario.duration, automata::Ticks{scenario.cycle.count * most});
    runtime::ScenarioOptions options;
    options.engine = runtime::ScenarioOptions::Engine::exact;
    const runtime::ScenarioResult once = run_scenario(document, scenario, options, {});
    const runtime::ScenarioResult again = run_scenario(document, scenario, options, {});
    CHECK(once.verdict() == again.verdict() && once.cycles == again.cycles && "same input, same flight");
    options.engine = runtime::ScenarioOptions::Engine::k_best;
    options.k = 4;
    (void)run_scenario(document, scenario, options, {});
  }
}

template <class Run>
void within_limits(const Run& run) {
  try {
    run();
  } catch (const base::InputError&) {
  } catch (const base::LimitError&) {
  } catch (const runtime::TooManyStates&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string> parts = parts_of({reinterpret_cast<const char*>(data), size});
  if (parts.size() != 3 && parts.size() != 4) return 0;
  compiler::Memory files;
  const std::vector<std::string> paths = {"main.rmpl", "plant.tcca", "flight.scn"};
  for (std::size_t i = 0; i < paths.size(); ++i) files.put(paths[i], parts[i]);
  if (parts.size() == 4) files.put("software.rmpl", parts[3]);
  const compiler::Compilation compiled = compiler::compile(paths, {}, files);
  if (!compiled.ok()) return 0;
  const automata::Document& document = compiled.document();
  for (const automata::Plant& plant : document.plants) {
    if (plant.components.size() > most_components) return 0;
  }
  for (const automata::Plant& plant : document.plants) {
    within_limits([&] { check_plant(plant); });
    within_limits([&] { plan(plant); });
    for (const automata::Program& program : document.programs) within_limits([&] { check_program(program, plant); });
  }
  for (const automata::ModelProgram& model : document.models) {
    if (model.locations.size() > most_locations || model.controls.size() > most_components) return 0;
  }
  within_limits([&] { fly(document); });
  return 0;
}
