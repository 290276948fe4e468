// rmpl-run diagnose: the leading diagnoses of one snapshot.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <numbers>

#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/diagnose/diagnose.hpp"
#include "tools/rmpl-run/command.hpp"
#include "tools/rmpl-run/competition.hpp"
#include "tools/rmpl-run/input.hpp"

namespace rmpl::runtime {
namespace {

struct Options {
  std::string plant;
  std::string observe;
  std::string scenario;
  DiagnoseOptions search;
  bool stats = false;
  Format format = Format::text;
};

constexpr const char* footer =
    R"(Every component is in some mode; a diagnosis names those that are in a fault mode, and all others are
nominal. It is consistent with the observations and the model. Best first is by prior probability.

exit code: 0 done; 2 an input is wrong

examples:
  rmpl-run diagnose c17.tcca --observe 'N1 = true, N22.o = false'
  rmpl-run diagnose valves.tcca --observe 'flow = none' -k 3 --format json
  rmpl-run diagnose c432.tcca --observe 'N1 = true, N223.o = false' -k 10 --ratio 100
  rmpl-run diagnose 74181.tcca --scenario 74181.000.scn --all-minimal --count)";

/// The prior as a number that any reader of decimal numbers takes; also where it underflows a double.
std::string probability_text(const Diagnosis& diagnosis) {
  constexpr double tiny = 1e-300;
  if (diagnosis.probability >= tiny || !std::isfinite(diagnosis.log_probability)) {
    JsonLine number;
    number.number(diagnosis.probability);
    return std::string(number.text());
  }
  const double decimal = diagnosis.log_probability / std::numbers::ln10;
  const double exponent = std::floor(decimal);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.9ge%.0f", std::pow(10.0, decimal - exponent), exponent);
  return text.data();
}

void write_json(JsonLine& json, const automata::Plant& plant, const Diagnoses& found) {
  json.open('{').key("diagnoses").open('[');
  for (const Diagnosis& diagnosis : found.diagnoses) {
    json.open('{').key("probability").digits(probability_text(diagnosis)).key("modes").open('{');
    for (const auto& [component, mode] : diagnosis.faults) {
      json.key(plant[component].name).string(plant[component].modes[mode.index()].name);
    }
    json.close('}').close('}');
  }
  json.close(']').key("count").digits(found.count.str()).key("cardinality");
  if (found.cardinality) {
    json.number(*found.cardinality);
  } else {
    json.null();
  }
  json.key("checked").number(found.checked).key("seconds").number(found.seconds).close('}');
}

std::string text_of(const automata::Plant& plant, const Diagnoses& found, bool count_only) {
  if (count_only) return found.count.str() + "\n";
  if (found.diagnoses.empty()) return "no diagnosis: no modes of the components are consistent with the observations\n";
  std::string text;
  for (const Diagnosis& diagnosis : found.diagnoses) {
    std::string probability = probability_text(diagnosis);
    if (probability.size() < 24) probability.append(24 - probability.size(), ' ');
    text += probability;
    if (diagnosis.faults.empty()) text += " nothing is at fault";
    bool first = true;
    for (const auto& [component, mode] : diagnosis.faults) {
      text += (first ? " " : ", ") + plant[component].name + " = " + plant[component].modes[mode.index()].name;
      first = false;
    }
    text += "\n";
  }
  return text;
}

Status run(Options options, const Common& common) {
  const auto compilation = load({options.plant}, common);
  if (!compilation) return Status::wrong;
  const automata::Plant& plant = only_plant(compilation->document(), options.plant);
  const auto observation = options.scenario.empty() ? assignments_option(options.observe, plant, "--observe", common)
                                                    : competition_observation(options.scenario, plant);
  if (!observation) return Status::wrong;
  options.search.all_minimal = options.search.all_minimal || options.search.count_only;
  const Diagnoses found = diagnose(plant, *observation, options.search);
  if (options.format == Format::json) {
    JsonLine json;
    write_json(json, plant, found);
    std::cout << json.text() << '\n';
  } else {
    std::cout << text_of(plant, found, options.search.count_only);
  }
  finish_output();
  if (options.stats || common.verbose) {
    std::cerr << found.checked << " candidates checked in " << found.seconds << " s\n";
  }
  return found.cut ? Status::undecided : Status::done;
}

}  // namespace

Subcommand diagnose_command(CLI::App& app, const Common& common) {
  CLI::App* command = app.add_subcommand("diagnose", "find the faults that explain one snapshot");
  const auto options = std::make_shared<Options>();
  command->add_option("PLANT", options->plant, "a .tcca model, or a compiled .json")->required();
  CLI::Option_group* seen = command->add_option_group("what is seen");
  seen->add_option("--observe", options->observe, "attributes and their values")->option_text("'x = v, ...'");
  seen->add_option("--scenario", options->scenario, "the last sensor readings in a file of the diagnosis competition")
      ->option_text("FILE");
  seen->require_option(1);
  command->add_option("-k", options->search.k, "how many diagnoses (default: 10)")
      ->option_text("N")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000'000}));
  command->add_option("--ratio", options->search.ratio, "none more than R times less likely than the best")
      ->option_text("R")
      ->check([](const std::string& text) {
        double ratio = 0;
        return CLI::detail::lexical_cast(text, ratio) && ratio >= 1 ? "" : "expected a number that is at least 1";
      });
  command->add_flag("--all-minimal", options->search.all_minimal, "every diagnosis with the fewest faults");
  command->add_flag("--count", options->search.count_only, "only how many those with the fewest faults are");
  add_format(*command, options->format);
  command->add_flag("--stats", options->stats, "say on standard error what it cost");
  command->footer(footer);
  return {command, [options, &common] { return run(*options, common); }};
}

}  // namespace rmpl::runtime
