// tcca-check program.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/program_command.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "base/error.hpp"
#include "tools/tcca-check/input.hpp"
#include "tools/tcca-check/output.hpp"
#include "verifier/closed_loop/check.hpp"
#include "verifier/export/witness_scenario.hpp"
#include "verifier/verdict/report.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::verifier {
namespace {

using base::InputError;
using Kind = ProgramProperty::Kind;

/// What is asked; where nothing is, the properties that every program should have.
std::vector<Property> properties_of(const automata::Plant& plant, const CommandLine& line) {
  std::vector<Property> result;
  for (const Kind kind : line.general) result.push_back(ProgramProperty{kind});
  for (const std::string& text : line.nevers) {
    result.push_back(ProgramProperty{Kind::never, formula(text, plant, "--never", line), {}, text});
  }
  for (const Promise& promise : line.eventuallys) {
    result.push_back(ProgramProperty{Kind::eventually, formula(promise.constraint, plant, "--eventually", line),
                                     *promise.within, promise.constraint});
  }
  for (const std::string& text : line.finallys) {
    result.push_back(ProgramProperty{Kind::finally, formula(text, plant, "--finally", line), {}, text});
  }
  if (!result.empty() || line.each_fault) return result;
  for (const Kind kind : {Kind::goal_conflict, Kind::no_plan, Kind::endless_wait, Kind::termination}) {
    result.push_back(ProgramProperty{kind});
  }
  return result;
}

std::string text_of(const Subject& subject, const std::vector<Property>& properties, const CheckOptions& options,
                    const std::vector<Answer>& answers, const CommandLine& line) {
  std::string text;
  for (std::size_t p = 0; p < properties.size(); ++p) {
    text += to_text(subject, {properties[p], options}, answers[p], colored(line, STDOUT_FILENO));
  }
  return text + (line.statistics ? statistics_text(answers.back().progress) : "");
}

Verdict print_table(const Subject& subject, const FaultTable& table, const CommandLine& line) {
  print(
      line, [&] { return to_text(subject, table) + (line.statistics ? statistics_text(table.progress) : ""); },
      [&] { return to_json(subject, table); }, [&] { return to_junit(subject, table); });
  if (std::any_of(table.rows.begin(), table.rows.end(), [](const FaultOutcome& row) { return row.fails(); })) {
    return Verdict::violated;
  }
  return table.limit ? Verdict::undecided : Verdict::holds;
}

/// Where the scenario goes, and what it calls its program and plant. Throws base::InputError before anything is
/// searched.
ScenarioFrame frame_of(const CommandLine& line, const Subject& subject) {
  namespace fs = std::filesystem;
  ScenarioFrame frame{{}, {}, {}, line.entry, line.period.value_or(line.cycle)};
  const fs::path folder = fs::absolute(line.scenario).lexically_normal().parent_path();
  for (const std::string& model : line.models) {
    const fs::path path = fs::absolute(model).lexically_normal();
    const std::string extension = path.extension().string();
    if (extension != ".rmpl" && extension != ".tcca") {
      throw base::InputError(model + ": a scenario names sources; expected a .rmpl and a .tcca file");
    }
    std::error_code missing;
    if (fs::equivalent(line.scenario, model, missing)) {
      throw base::InputError("--scenario would overwrite its input, " + model);
    }
    (extension == ".rmpl" ? frame.program : frame.plant) = path.lexically_proximate(folder).string();
  }
  frame.name = title(subject);
  return frame;
}

void write(const std::string& path, const std::string& text) {
  const std::string draft = path + ".part";
  std::ofstream file(draft, std::ios::binary);
  file << text;
  file.close();
  std::error_code failure;
  if (file) std::filesystem::rename(draft, path, failure);
  if (!file || failure) {
    std::filesystem::remove(draft, failure);
    throw base::InputError(path + ": cannot be written");
  }
}

/// Writes the first violation as a scenario. One of dense time is looked for again in cycles.
void write_scenario(const ScenarioFrame& frame, const Subject& subject, automata::PlantStep& step,
                    const std::vector<Property>& properties, const std::vector<Answer>& answers,
                    const CheckOptions& options, const CommandLine& line, const Limits& limits) {
  const auto violated = [](const Answer& a) { return a.witness.has_value(); };
  const auto at = std::find_if(answers.begin(), answers.end(), violated);
  if (at == answers.end()) {
    if (!line.quiet) std::cerr << "tcca-check: nothing is violated, so no scenario is written\n";
    return;
  }
  const Property& property = properties[static_cast<std::size_t>(at - answers.begin())];
  std::optional<Witness> witness = at->witness;
  if (!options.period) {
    CheckOptions sampled = options;
    sampled.period = frame.cycle;
    witness = check(*subject.program, step, {property}, sampled, limits).front().witness;
    if (!witness) {
      std::cerr << "tcca-check: warning: in cycles of " << automata::format_seconds(frame.cycle)
                << " s the violation was not found, so no scenario is written; --cycle takes another length\n";
      return;
    }
  }
  write(line.scenario, scenario_text(step, std::get<ProgramProperty>(property), *witness, frame));
}

}  // namespace

Verdict run_program(const CommandLine& line, const Limits& limits) {
  const compiler::Compilation compilation = load(line);
  const automata::Document& document = compilation.document();
  if (document.programs.size() != 1) {
    throw base::InputError("the input holds " + std::to_string(document.programs.size()) +
                           " control programs; expected one, as in a .rmpl file");
  }
  const automata::Plant& plant = document.plants.front();
  const automata::Program& program = document.programs.front();
  const Subject subject{plant, &program};
  const std::vector<Property> properties = properties_of(plant, line);
  const CheckOptions options{
      .period = line.period, .faults = line.faults, .entailed = line.entailed, .from = starting_modes(plant, line)};
  automata::PlantStep step(plant);
  Verdict result = Verdict::undecided;
  if (line.each_fault) {
    const FaultTable table = check_each_fault(program, step, properties, options, limits);
    if (limits.report) std::fputs("\r\033[K", stderr);
    result = print_table(subject, table, line);
  } else {
    std::optional<ScenarioFrame> frame;
    if (!line.scenario.empty()) frame = frame_of(line, subject);
    const std::vector<Answer> answers = check(program, step, properties, options, limits);
    if (limits.report) std::fputs("\r\033[K", stderr);
    if (answers.front().startless) warn_of_no_start("nothing can be violated");
    print(
        line, [&] { return text_of(subject, properties, options, answers, line); },
        [&] { return to_json(subject, properties, answers); }, [&] { return to_junit(subject, properties, answers); });
    if (frame) write_scenario(*frame, subject, step, properties, answers, options, line, limits);
    result = overall(answers);
  }
  finish_output();
  return result;
}

}  // namespace rmpl::verifier
