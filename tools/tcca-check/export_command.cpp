// tcca-check export.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/export_command.hpp"

#include <iostream>
#include <sstream>

#include "base/error.hpp"
#include "tools/tcca-check/input.hpp"
#include "tools/tcca-check/output.hpp"
#include "verifier/export/prism.hpp"
#include "verifier/export/write.hpp"
#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using base::InputError;

namespace {

void write(std::ostream& out, automata::PlantStep& step, const ExportQuestion& question, const CommandLine& line,
           const Limits& limits) {
  switch (line.tool) {
    case CommandLine::Tool::tchecker:
    case CommandLine::Tool::uppaal: {
      const bool uppaal = line.tool == CommandLine::Tool::uppaal;
      if (line.period) {
        throw base::InputError(std::string(uppaal ? "uppaal" : "tchecker") +
                               " reads time as dense; expected no period");
      }
      const TimedAutomaton automaton = unfold(step, question, limits);
      if (automaton.locations.empty()) {
        if (!question.from.empty()) refuse_start();
        warn_of_no_start("nothing is reachable");
      }
      (uppaal ? write_uppaal : write_tchecker)(out, step.plant(), automaton);
      return;
    }
    case CommandLine::Tool::prism:
      if (!line.period)
        throw base::InputError("prism has steps and no dense time; expected a period, as in --time 0.5s");
      write_prism(out, step, question, *line.period, limits);
      return;
  }
}

}  // namespace

bool run_export(const CommandLine& line, const Limits& limits) {
  const compiler::Compilation compilation = load(line);
  const automata::Plant& plant = compilation.document().plants.front();
  const bool safety = !line.never.empty();
  const ExportQuestion question{
      safety ? formula(line.never, plant, "--never", line) : formula(line.target, plant, "--target", line),
      line.entailed, line.faults, line.commands, starting_modes(plant, line)};
  demand_modes(plant, question.from);
  automata::PlantStep step(plant);
  // As a whole or not at all: what cannot be said may be met late.
  std::ostringstream out;
  try {
    write(out, step, question, line, limits);
  } catch (const LimitReached&) {
    std::cerr << "tcca-check: a limit was reached before all mode combinations were met: nothing is written\n";
    return false;
  }
  std::cout << std::move(out).str();
  finish_output();
  return true;
}

}  // namespace rmpl::verifier
