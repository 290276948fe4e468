// tcca-check check.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include "base/error.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/suggestion.hpp"
#include "tools/tcca-check/check_options.hpp"
#include "tools/tcca-check/commands.hpp"
#include "verifier/plant/check_all.hpp"
#include "verifier/verdict/table.hpp"

namespace rmpl::tools {

using automata::PlantProperty;
using verifier::Commands;

namespace {

struct Options {
  std::string model;
  std::string properties;         ///< a path, or `-`
  std::vector<std::string> only;  ///< the names of those to check; empty: all
  Budget budget;
  unsigned threads = 1;
  bool statistics = false;
};

Commands commands_of(PlantProperty::Commands commands) {
  switch (commands) {
    case PlantProperty::Commands::none:
      return Commands::none;
    case PlantProperty::Commands::one:
      return Commands::one;
    case PlantProperty::Commands::any:
      return Commands::any;
  }
  return Commands::one;
}

verifier::Property property_of(const PlantProperty& stated) {
  switch (stated.claim) {
    case PlantProperty::Claim::never:
      return verifier::Safety{stated.formula, {}, false};
    case PlantProperty::Claim::reach:
      return verifier::Reachability{stated.formula, {}, false};
    case PlantProperty::Claim::response:
      break;
  }
  return verifier::Response{stated.formula, stated.then, stated.within};
}

std::vector<PlantProperty> read_properties(const Options& options, const Common& common, const automata::Plant& plant) {
  auto compiled = compiler::compile_properties(options.properties, plant);
  tell_findings(compiled.findings, common);
  if (!compiled.properties) throw Rejected{};
  std::vector<PlantProperty> all = std::move(*compiled.properties);
  std::vector<std::string_view> names;
  for (const PlantProperty& property : all) names.emplace_back(property.name);
  for (const std::string& name : options.only) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw base::InputError("--only: " + options.properties + " has no property '" + name + "'" +
                             suggestion_or_list(name, names));
    }
  }
  if (!options.only.empty()) {
    std::erase_if(all, [&](const auto& p) {
      return std::find(options.only.begin(), options.only.end(), p.name) == options.only.end();
    });
  }
  return all;
}

std::vector<verifier::Question> questions_of(const std::vector<PlantProperty>& stated, const Options& options) {
  std::vector<verifier::Question> questions;
  for (const PlantProperty& p : stated) {
    questions.push_back({property_of(p),
                         {.period = p.period,
                          .faults = p.faults,
                          .commands = commands_of(p.commands),
                          .entailed = p.entailed,
                          .threads = options.threads,
                          .from = p.from},
                         options.budget.bounds()});
  }
  return questions;
}

ExitStatus run(const Options& options, const Common& common) {
  check_standard_input({options.model, options.properties});
  const compiler::Compilation compilation = load({options.model}, common);
  const automata::Plant& plant = only_plant(compilation.document(), options.model);
  const std::vector<PlantProperty> stated = read_properties(options, common, plant);
  std::vector<verifier::Question> questions = questions_of(stated, options);
  automata::PlantStep step(plant);
  std::vector<verifier::Answer> answers = verifier::check_all(step, questions, limits(options.budget, common));
  if (std::any_of(answers.begin(), answers.end(), [](const verifier::Answer& a) { return a.startless; })) {
    warn_of_no_start("nothing is reachable");
  }
  std::vector<verifier::Claim> claims;
  for (std::size_t q = 0; q < stated.size(); ++q) {
    claims.push_back({stated[q].name, std::move(questions[q]), stated[q].expect_violated, std::move(answers[q])});
  }
  print_answer(
      common, [&] { return verifier::to_table(plant, claims, options.statistics, output_painter(common.color).color); },
      [&] { return verifier::to_json(plant, claims); }, [&] { return verifier::to_junit(plant, claims); });
  const verifier::Count found = verifier::count(claims);
  if (found.unexpected > 0) return ExitStatus::violated;
  return found.undecided > 0 ? ExitStatus::undecided : ExitStatus::done;
}

}  // namespace

void add_check(Program& program) {
  CLI::App* command =
      program.app().add_subcommand("check", "do all properties of a file come out as it expects? a table of verdicts");
  const auto options = std::make_shared<Options>();
  add_model(*command, options->model);
  command->add_option("PROPERTIES", options->properties, "what is claimed of it: .props; - for standard input")
      ->required();
  add_texts(*command, "--only", options->only, "NAME", "check this property alone; may be given several times");
  add_threads(*command, options->threads);
  add_budget(*command, options->budget);
  add_format(*command, program.common(), true);
  command->add_flag("--stats", options->statistics, "tell what each search has cost; properties may share one");
  program.add({command, [options, &common = program.common()] { return run(*options, common); }});
}

}  // namespace rmpl::tools
