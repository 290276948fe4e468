// Each question is asked of the library that answers the programs, and its answer written by the same function.
// SPDX-License-Identifier: MIT
#include "python/questions.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "automata/step/plant_step.hpp"
#include "automata/time/time.hpp"
#include "base/error.hpp"
#include "base/work_together.hpp"
#include "compiler/session/provider.hpp"
#include "python/errors.hpp"
#include "runtime/executive/answer/diagnosis_answer.hpp"
#include "runtime/executive/answer/plan_answer.hpp"
#include "runtime/executive/campaign/flight.hpp"
#include "runtime/executive/campaign/table.hpp"
#include "verifier/claims/stated_claims.hpp"
#include "verifier/closed_loop/check_all.hpp"
#include "verifier/slice/warnings.hpp"
#include "verifier/verdict/table.hpp"

namespace rmpl::python {
namespace {

using runtime::JsonLine;

/// What was asked of the model's plant in words is no mode of a component.
void expect_attributes(const automata::Plant& plant, const std::vector<automata::Assignment>& observation) {
  for (const automata::Assignment& reading : observation) {
    if (!plant.component_of(reading.variable)) continue;
    throw base::InputError("observe: '" + plant.variables.name(reading.variable) +
                           "' is a component: no sensor reads its mode; expected an attribute");
  }
}

}  // namespace

std::string plan(const ModelPointer& model, const std::string& from, const std::string& goal, bool one_step,
                 const std::string& cycle) {
  const automata::Plant& plant = model->plant();
  const auto given = model->assignments(from, "from");
  const automata::Formula formula = model->goal(goal, "goal");
  const automata::Ticks length = cycle.empty() ? automata::Ticks{} : duration(cycle, "cycle");
  automata::PlantStep step(plant);
  const automata::Modes modes = runtime::modes_from(plant, given);
  runtime::expect_possible(step, modes);
  JsonLine json;
  write(json, plant, runtime::answer_plan(step, modes, formula, one_step, length));
  return json.text();
}

std::string diagnose(const ModelPointer& model, const std::string& observe, const std::string& modes, std::size_t k,
                     double ratio, bool all_minimal, bool first, bool count) {
  const automata::Plant& plant = model->plant();
  const auto observation = model->assignments(observe, "observe");
  expect_attributes(plant, observation);
  runtime::DiagnoseOptions options;
  options.k = k;
  options.ratio = ratio;
  options.first = first;
  options.count_only = count;
  options.all_minimal = all_minimal || first || count;
  const runtime::Diagnoses found =
      modes.empty()
          ? runtime::diagnose(plant, observation, options)
          : runtime::diagnose(runtime::with_known(plant, model->assignments(modes, "modes")), observation, options);
  JsonLine json;
  write(json, plant, found);
  return json.text();
}

std::string check(const ModelPointer& model, const std::string& properties, const std::optional<std::string>& text,
                  const std::vector<std::string>& only, const Budget& budget) {
  const automata::Plant& plant = model->plant();
  const auto& programs = model->document().programs;
  const verifier::Subject subject{plant, programs.size() == 1 ? &programs.front() : nullptr};
  compiler::Disk disk;
  compiler::Overlay sources(disk);
  if (text) sources.put(properties, *text);
  auto compiled = compiler::compile_properties(properties, plant, subject.program != nullptr, sources);
  if (!compiled.properties) reject(compiled.findings);
  std::vector<automata::PlantProperty> stated = *std::move(compiled.properties);
  const auto is_asked = [&](const automata::PlantProperty& p) {
    return only.empty() || std::find(only.begin(), only.end(), p.name) != only.end();
  };
  const auto unknown = std::find_if(only.begin(), only.end(), [&](const std::string& name) {
    return std::none_of(stated.begin(), stated.end(), [&](const auto& p) { return p.name == name; });
  });
  if (unknown != only.end()) throw base::InputError("only: " + properties + " has no property '" + *unknown + "'");
  std::erase_if(stated, [&](const auto& p) { return !is_asked(p); });
  const verifier::StatedClaims asked(subject, std::move(stated), {budget.states, budget.time, budget.bytes});
  return run_interruptibly([&](const std::atomic<bool>& stop) {
    verifier::Limits limits;
    limits.states = budget.states;
    if (budget.time && !budget.time->is_infinite()) limits.time.emplace(budget.time->seconds());
    limits.bytes = budget.bytes;
    limits.interrupted = &stop;
    const auto& questions = asked.questions();
    verifier::Slices slices(plant);
    std::vector<verifier::Answer> answers = verifier::check_all(subject, slices, questions, limits);
    for (std::size_t q = 0; q < questions.size(); ++q) {
      for (auto& warning : verifier::warnings_of(questions[q], slices, subject.program)) {
        answers[q].warnings.push_back(std::move(warning.text));
      }
      if (auto warning = verifier::warning_of(questions[q], answers[q], slices)) {
        answers[q].warnings.push_back(*std::move(warning));
      }
    }
    return verifier::to_json(subject, asked.with(std::move(answers), limits)).dump();
  });
}

std::string campaign(const ModelPointer& model, const std::optional<std::string>& scenario, std::uint64_t runs,
                     std::uint64_t faults, std::uint64_t seed, unsigned jobs, bool unmodelled) {
  const automata::Document& document = model->document();
  const automata::Scenario& flown = model->scenario(scenario);
  runtime::expect_faults(document, flown, faults);
  std::vector<std::optional<runtime::CampaignRun>> results(runs);
  run_interruptibly([&](const std::atomic<bool>& stop) {
    runtime::ScenarioOptions options;
    options.graph = runtime::reconfiguration_graph(document.plants[flown.plant]);
    options.interrupted = [&] { return stop.load(); };
    runtime::CampaignPlan plan;
    plan.seed = seed;
    plan.faults = faults;
    plan.unmodelled = unmodelled;
    plan.cycles = runtime::cycles_without_faults(document, flown, options);
    base::share_tasks(jobs, runs, [&](std::size_t run, std::size_t) {
      if (!options.interrupted()) results[run] = runtime::fly_run(document, flown, plan, run, options);
    });
  });
  JsonLine json;
  json.open('[');
  for (const auto& run : results) {
    if (run) write(json, *run, document.plants[flown.plant]);
  }
  json.close(']');
  return json.text();
}

}  // namespace rmpl::python
