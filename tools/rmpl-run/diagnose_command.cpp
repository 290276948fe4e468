// rmpl-run diagnose: the leading diagnoses of one snapshot.
// SPDX-License-Identifier: MIT
#include <memory>
#include <sstream>

#include "automata/assignment_text.hpp"
#include "base/error.hpp"
#include "runtime/executive/answer/diagnosis_answer.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/diagnose/diagnose.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/competition.hpp"
#include "tools/rmpl-run/diagnose_model.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

using runtime::Diagnoses;
using runtime::Diagnosis;
using runtime::JsonLine;

struct DiagnoseOptions {
  std::string plant;
  std::string main;  ///< the definition that a model program starts with; empty: the one that no other calls
  std::string observe;
  std::string modes;
  std::string scenario;
  runtime::DiagnoseOptions search;
  bool stats = false;
};

constexpr const char* diagnose_footer =
    R"(Every component is in some mode; a diagnosis names those that are in a fault mode, and all others are
nominal. It is consistent with the observations and the model. Best first is by prior probability.
Of a model program a diagnosis names what is marked in the threads that took an improbable draw, of a
branch that another one of its choose is likelier than. The probability is that of these draws. Nothing
is known of what was before; for that, use estimate --window.

exit code: 0 done; 2 an input is wrong; 3 a limit was hit, or there was not enough memory

examples:
  rmpl-run diagnose c17.tcca --observe 'N1 = true, N22.o = false'
  rmpl-run diagnose valves.tcca --observe 'flow = none' -k 3 --format json
  rmpl-run diagnose hall.tcca --observe 'lamp.light = dark' --modes 'breaker = on'
  rmpl-run diagnose c432.tcca --observe 'N1 = true, N223.o = false' -k 10 --ratio 100
  rmpl-run diagnose 74181.tcca --scenario 74181.000.scn --all-minimal --count
  rmpl-run diagnose c880.tcca --scenario c880.000.scn --first)";

std::string text_of(const automata::Plant& plant, const Diagnoses& found, bool count_only) {
  if (count_only) return found.count.str() + "\n";
  if (found.diagnoses.empty()) return "no diagnosis: the observations contradict every combination of modes\n";
  std::string text;
  for (const Diagnosis& diagnosis : found.diagnoses) {
    std::string probability = runtime::probability_text(diagnosis);
    if (probability.size() < 24) probability.append(24 - probability.size(), ' ');
    text += probability;
    if (diagnosis.faults.empty()) text += " nothing is at fault";
    bool first = true;
    for (const auto& [component, mode] : diagnosis.faults) {
      text += (first ? " " : ", ") + to_text(plant[component], mode);
      first = false;
    }
    text += "\n";
  }
  return text;
}

[[noreturn]] void refuse_mode(const std::string& name) {
  throw base::InputError("--observe: '" + name + "' is a component: no sensor reads its mode; expected an attribute");
}

/// A model program is diagnosed by its threads.
ExitStatus run_model(const automata::ModelProgram& program, const DiagnoseOptions& options, const Common& common) {
  const runtime::DiagnoseOptions& search = options.search;
  const bool modes = !options.modes.empty();
  if (search.all_minimal || search.first || search.count_only || !options.scenario.empty() || modes) {
    throw base::InputError(options.plant +
                           ": --all-minimal, --first, --count, --modes and --scenario apply to plants of components, "
                           "but this is a model program");
  }
  const auto observation = assignments_option(options.observe, program, "--observe", common);
  return diagnose_model(program, options.plant, observation, search.k, search.ratio, options.stats, common);
}

ExitStatus run(DiagnoseOptions options, const Common& common) {
  check_standard_input({options.plant, options.scenario});
  const compiler::Compilation compilation = load({options.plant}, common, {.main = options.main});
  if (is_model_program(compilation.document())) {
    return run_model(only_model_program(compilation.document(), options.plant), options, common);
  }
  const automata::Plant& plant = only_plant(compilation.document(), options.plant);
  const auto observation = options.scenario.empty() ? assignments_option(options.observe, plant, "--observe", common)
                                                    : competition_observation(options.scenario, plant);
  for (const automata::Assignment& reading : observation) {
    if (plant.component_of(reading.variable)) refuse_mode(plant.variables.name(reading.variable));
  }
  if (options.search.first && options.search.count_only) {
    throw base::InputError(
        "--first and --count exclude each other: --first gives one diagnosis, --count only their number");
  }
  options.search.all_minimal = options.search.all_minimal || options.search.first || options.search.count_only;
  const Diagnoses found =
      options.modes.empty()
          ? runtime::diagnose(plant, observation, options.search)
          : runtime::diagnose(runtime::with_known(plant, assignments_option(options.modes, plant, "--modes", common)),
                              observation, options.search);
  if (common.format == Format::json) {
    JsonLine json;
    write(json, plant, found);
    print_json(std::string(json.text()) + "\n");
  } else {
    print(text_of(plant, found, options.search.count_only));
  }
  if (options.stats || common.verbose) {
    std::ostringstream cost;
    cost << found.checked << " candidates checked in " << found.seconds << " s\n";
    print_error(cost.str());
  }
  return found.cut ? ExitStatus::undecided : ExitStatus::done;
}

}  // namespace

void add_diagnose(Program& program) {
  Command command = program.add_command("diagnose", "find the faults that explain one snapshot");
  const auto options = std::make_shared<DiagnoseOptions>();
  add_plant(command, options->plant, options->main);
  Option observe = command.add_option("--observe", options->observe, "the observations: attributes and their values")
                       .option_text("'x = v, ...'");
  Option readings = command
                        .add_option("--scenario", options->scenario,
                                    "the observations: the last sensor readings in a file of the diagnosis competition")
                        .option_text("FILE");
  command.require_one(observe, readings);
  command.add_option("--modes", options->modes, "known nominal modes: each component is in the given mode or at fault")
      .option_text("'c = m, ...'");
  constexpr std::uint64_t most = 1'000'000'000;
  Option k = add_whole_number(command, "-k", options->search.k, 1, most, "how many diagnoses (default: 10)");
  const auto ratio = [](const std::string& text) {
    const std::optional<double> value = real_number(text);
    if (value && *value >= 1) return *value;
    throw BadValue("expected a number that is at least 1, not '" + text + "'");
  };
  add_read(command, "--ratio", options->search.ratio, ratio,
           "omit diagnoses that are more than R times less likely than the best")
      .option_text("R");
  command.add_flag("--all-minimal", options->search.all_minimal, "list every diagnosis with the fewest faults");
  command
      .add_flag("--first", options->search.first,
                "print only one diagnosis with the fewest faults, which proves their number")
      .excludes(k);
  command.add_flag("--count", options->search.count_only, "print only the number of diagnoses with the fewest faults");
  add_format(command, program.common());
  command.add_flag("--stats", options->stats, "print the cost on standard error");
  command.footer(diagnose_footer);
  program.add({command,
               [options, &common = program.common()] { return within_limits([&] { return run(*options, common); }); }});
}

}  // namespace rmpl::tools
