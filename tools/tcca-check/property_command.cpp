// tcca-check reachability, safety, response.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/property_command.hpp"

#include <unistd.h>

#include <cstdio>
#include <iostream>

#include "tools/tcca-check/input.hpp"
#include "tools/tcca-check/output.hpp"
#include "verifier/plant/check.hpp"
#include "verifier/verdict/report.hpp"
#include "verifier/verdict/table.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::verifier {

using automata::Plant;

namespace {

Property property(const Plant& plant, const CommandLine& line) {
  const Window window{line.not_before, line.by};
  switch (line.kind) {
    case CommandLine::Kind::reachability:
      return Reachability{formula(line.target, plant, "--target", line), window, line.fastest};
    case CommandLine::Kind::safety:
      return Safety{formula(line.never, plant, "--never", line), window, line.fastest};
    case CommandLine::Kind::response:
    case CommandLine::Kind::program:
    case CommandLine::Kind::check_file:
    case CommandLine::Kind::export_model:
      break;
  }
  return Response{formula(line.after, plant, "--after", line), formula(line.then, plant, "--within", line),
                  line.within};
}

/// The property as it was asked for.
std::string title(const CommandLine& line, const Property& asked) {
  const std::string kind = name_of(asked) + " ";
  if (std::holds_alternative<Reachability>(asked)) return kind + line.target;
  if (std::holds_alternative<Safety>(asked)) return kind + line.never;
  return kind + line.after + " within " + automata::format_seconds(line.within) + " s " + line.then;
}

CheckOptions options(const Plant& plant, const CommandLine& line) {
  CheckOptions result{.period = line.period,
                      .faults = line.faults,
                      .commands = line.commands,
                      .entailed = line.entailed,
                      .fewest_faults = line.fewest_faults,
                      .cut_sets = line.cut_sets.has_value(),
                      .symmetry = !line.no_symmetry,
                      .threads = line.threads,
                      .from = starting_modes(plant, line)};
  if (line.fewest_faults && !line.faults_given) result.faults.reset();
  if (line.cut_sets) result.faults = line.cut_sets;
  return result;
}

}  // namespace

Verdict run_property(const CommandLine& line, const Limits& limits) {
  const compiler::Compilation compilation = load(line);
  const Plant& plant = compilation.document().plants.front();
  const Property asked = property(plant, line);
  if (line.verbose) {
    std::cerr << "checking " << name_of(asked) << " of " << plant.name << ": " << plant.components.size()
              << " components, " << plant.controls.size() << " controls\n";
  }
  automata::PlantStep step(plant);
  const Question question{asked, options(plant, line)};
  const Answer answer = check(step, question.property, question.options, limits);
  if (limits.report) std::fputs("\r\033[K", stderr);
  if (answer.startless) warn_of_no_start("nothing is reachable");
  const Subject subject{plant};
  print(
      line,
      [&] {
        return to_text(subject, question, answer, colored(line, STDOUT_FILENO)) +
               (line.statistics ? statistics_text(answer.progress) : "");
      },
      [&] { return to_json(subject, question, answer); },
      [&] {
        return to_junit(plant, {{title(line, asked), question, false, answer}});
      });
  finish_output();
  return answer.verdict;
}

}  // namespace rmpl::verifier
