// tcca-check fmea.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/output_file.hpp"
#include "grammar/source/render.hpp"
#include "tools/shared/models.hpp"
#include "tools/tcca-check/check_options.hpp"
#include "tools/tcca-check/commands.hpp"
#include "tools/tcca-check/fmea_flights.hpp"
#include "verifier/claims/stated_property.hpp"
#include "verifier/property/initial_modes.hpp"
#include "verifier/safety/fmea.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::tools {
namespace {

struct FmeaOptions {
  std::string program, plant, entry, properties, output;
  std::vector<std::string> components;
  std::optional<automata::Ticks> period;
  Budget budget;
  bool statistics = false;
};

/// The claims of the file, under the program: what is never to hold of the plant is not to hold under it either.
std::vector<verifier::NamedProperty> mission_of(const FmeaOptions& options, const automata::Plant& plant,
                                                const Common& common) {
  std::vector<verifier::NamedProperty> result;
  if (options.properties.empty()) return result;
  auto compiled = compiler::compile_properties(options.properties, plant, true);
  tell_findings(compiled.findings, common);
  if (!compiled.properties) throw Rejected{grammar::render_text(compiled.findings, false)};
  using Claim = automata::PlantProperty::Claim;
  for (automata::PlantProperty stated : *compiled.properties) {
    if (stated.claim == Claim::probability) continue;
    if (!stated.of_program && stated.claim != Claim::never && stated.claim != Claim::response) continue;
    if (stated.expect_violated) continue;  // it is not what the mission is
    stated.of_program = true;
    result.push_back(
        {stated.name, std::get<verifier::ProgramProperty>(verifier::property_of(stated, plant)), stated.severity});
  }
  return result;
}

std::vector<automata::ComponentId> components_of(const std::vector<std::string>& names, const automata::Plant& plant) {
  std::vector<automata::ComponentId> result;
  for (const std::string& name : names) {
    const auto at = std::find_if(plant.components.begin(), plant.components.end(),
                                 [&](const automata::Component& component) { return component.name == name; });
    if (at == plant.components.end()) {
      std::vector<std::string> known;
      for (const automata::Component& component : plant.components) known.push_back(component.name);
      throw base::InputError("--component " + name + ": the plant has no such component" +
                             base::suggestion(name, known));
    }
    result.emplace_back(static_cast<std::size_t>(at - plant.components.begin()));
  }
  return result;
}

ExitStatus run(const FmeaOptions& options, const Common& common) {
  const bool csv = options.output.ends_with(".csv");
  if (!options.output.empty() && !csv && !options.output.ends_with(".html")) {
    throw base::InputError("-o " + options.output + ": expected a name that ends in .csv or .html");
  }
  const std::vector<std::string> paths =
      options.plant.empty() ? std::vector{options.program} : std::vector{options.program, options.plant};
  const std::string named = options.plant.empty() ? options.program : options.program + ", " + options.plant;
  const compiler::Compilation compilation = load(paths, common, {.main = options.entry, .model_is_plant = true});
  const automata::Program& program = only_program(compilation.document(), named);
  const automata::Plant& plant = only_plant(compilation.document(), named);
  const std::vector<verifier::NamedProperty> mission = mission_of(options, plant, common);
  const std::vector<automata::ComponentId> components = components_of(options.components, plant);
  automata::PlantStep step(plant);
  verifier::CheckOptions free;
  free.period = options.period;
  const verifier::Limits most = limits(options.budget, common);
  verifier::FailureModes table = verifier::failure_modes(program, step, mission, free, most, components);
  fly_rows(compilation.document(), table, options.period.value_or(automata::Scenario{}.cycle), most.interrupted);
  if (!options.output.empty()) {
    base::write_file(options.output,
                     csv ? verifier::to_csv(plant, table) : verifier::to_html({plant, &program}, table));
  }
  print_answer(
      common,
      [&] {
        return verifier::to_text(plant, table) + (options.statistics ? verifier::statistics_text(table.progress) : "");
      },
      [&] { return verifier::to_json(plant, table); },
      []() -> std::string { throw base::InputError("--format junit is for verdicts; expected text or json"); });
  return table.limit ? ExitStatus::undecided : ExitStatus::done;
}

constexpr const char* fmea_notes =
    R"(Exit status: 0 the table is told, 2 the command line or an input is wrong, 3 undecided: a limit or
a signal ended it before it was whole, 4 an internal error, and nothing is claimed.)";

}  // namespace

void add_fmea(Program& program) {
  Command command = program.add_command("fmea", "a table of failure modes: effects, detection, response, severity");
  const auto options = std::make_shared<FmeaOptions>();
  command.add_option("PROGRAM", options->program, "the program: .rmpl, or a compiled .json of program and plant")
      .required();
  command.add_option("PLANT", options->plant, "the plant: .tcca or compiled .json");
  add_text(command, "--main", options->entry, "NAME",
           "the definition to start with (default: the one that no other definition calls)");
  add_text(command, "--props", options->properties, "FILE.props", "the properties that state the mission");
  add_texts(command, "--component", options->components, "NAME",
            "only the rows of this component; may be given several times");
  add_text(command, "-o,--output", options->output, "OUT.csv|OUT.html", "also write the table to this file");
  const auto period = [](const std::string& text) {
    return text == "dense" ? std::nullopt : std::optional(positive_duration(text));
  };
  add_read(command, "--time", options->period, period,
           "dense time (the default), or the period at whose multiples steps happen")
      .option_text("dense|T");
  add_budget(command, options->budget);
  add_answer_form(command, program.common(), options->statistics);
  command.footer(fmea_notes);
  program.add({command, [options, &common = program.common()] { return run(*options, common); }, AtSignal::tell});
}

}  // namespace rmpl::tools
