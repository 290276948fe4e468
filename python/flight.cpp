// One flight with its observers.
// SPDX-License-Identifier: MIT
#include "python/flight.hpp"

#include <atomic>
#include <utility>

#include "base/painter.hpp"
#include "compiler/diagram/plant_diagram.hpp"
#include "compiler/diagram/program_diagram.hpp"
#include "python/errors.hpp"
#include "runtime/executive/scenario/report.hpp"
#include "runtime/executive/scenario/story.hpp"
#include "runtime/report/exports.hpp"
#include "runtime/report/page.hpp"
#include "runtime/report/recorder.hpp"

namespace rmpl::python {

Flight::Flight(ModelPointer model, const std::optional<std::string>& scenario, const runtime::ScenarioOptions& options,
               runtime::TraceDetail detail)
    : model_(std::move(model)), scenario_(model_->scenario(scenario)) {
  const automata::Document& document = model_->document();
  const automata::Plant& plant = document.plant_of(scenario_);
  const automata::Program& program = document.programs[scenario_.program];
  const base::Painter plain;
  runtime::TraceWriter trace(
      plant, program, [this](std::string_view line) { trace_ += line; }, detail);
  runtime::Story story(plant, program, runtime::MomentColumn(scenario_.duration, scenario_.cycle), plain, {},
                       [this](const std::string& line) { story_ += line + "\n"; });
  runtime::Recorder recorder(document, scenario_);
  story_ = runtime::heading(document, scenario_, options.seed.value_or(scenario_.seed), plain) + "\n";
  result_ = run_interruptibly([&](const std::atomic<bool>& stop) {
    runtime::ScenarioOptions run = options;
    run.interrupted = [&stop] { return stop.load(); };
    return runtime::run_scenario(document, scenario_, run, {&story, &trace, &recorder});
  });
  trace.keep();
  story_ += "\n" + runtime::summary(scenario_, result_, plain);
  data_ = recorder.finish(result_);
}

std::string Flight::result() const {
  runtime::JsonLine json;
  runtime::write_result(json, scenario_, result_);
  return json.text();
}

std::string Flight::csv() const { return runtime::to_csv(data_); }

std::string Flight::vcd() const { return runtime::to_vcd(data_); }

std::string Flight::mcap() const { return runtime::to_mcap(data_); }

std::string Flight::program_dot() const { return compiler::program_diagram(*data_.program, std::nullopt); }

std::string Flight::plant_dot() const {
  return compiler::plant_diagram(*data_.plant, {}, std::nullopt, compiler::Badges::room);
}

std::string Flight::html(const std::string& title, const std::string& program, const std::string& plant,
                         const std::string& missing) const {
  return runtime::to_html({title, {{data_.plant, data_.program, {program, plant, missing}}}, {data_}});
}

}  // namespace rmpl::python
