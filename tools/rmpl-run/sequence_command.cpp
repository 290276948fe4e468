// rmpl-run sequence: state estimates in, markings and goals out.
// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_file.hpp"
#include "runtime/executive/sequence/log_run.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

struct SequenceOptions {
  std::string program;
  std::string plant;
  std::string log;
  std::string main;
};

constexpr const char* sequence_footer =
    R"(Line i of the log holds "time" and "estimate" (and, if there are any, "observations") at the start of
cycle i; what line i + 1 holds is what cycle i reads back. So n + 1 lines are n cycles, and for each a
line comes out: "cycle", "time", the "marking" with which it starts, its "goal", and the active "clocks".
The run ends with the empty marking. With a plant its model says what follows from an estimate; without
one, names are taken as they come. A trace of rmpl-run scenario is such a log. What comes from standard
input is answered line by line: a cycle as soon as the line is there that it reads back.

exit code: 0 done; 2 an input is wrong, and of a file nothing was answered

examples:
  rmpl-run sequence entry.rmpl --log estimates.jsonl
  rmpl-run sequence entry.rmpl lander.tcca --log flight.jsonl)";

ExitStatus run(const SequenceOptions& options, const Common& common) {
  std::vector<std::string> paths{options.program};
  if (!options.plant.empty()) paths.push_back(options.plant);
  check_standard_input({options.program, options.plant, options.log});
  const compiler::Compilation compilation = load(paths, common, {.main = options.main, .model_is_plant = true});
  const automata::Document& document = compilation.document();
  const automata::Program& program = only_program(document, options.program);
  base::InputFile input(options.log);
  const bool modelled = !options.plant.empty() || !document.plants.empty();
  const automata::Plant* const plant = modelled ? &only_plant(document, options.plant) : nullptr;
  // A file is checked in full before anything is answered; what can be read only once is answered as it comes.
  if (base::is_read_again(options.log)) {
    print_json(modelled ? runtime::sequence_log(program, *plant, input.stream(), input.name())
                        : runtime::sequence_log(program, input.stream(), input.name()));
    return ExitStatus::done;
  }
  const auto answer = [](std::string_view line) { print_json(std::string(line) + "\n"); };
  if (modelled) {
    runtime::sequence_log(program, *plant, input.stream(), input.name(), answer);
  } else {
    runtime::sequence_log(program, input.stream(), input.name(), answer);
  }
  return ExitStatus::done;
}

}  // namespace

void add_sequence(Program& program) {
  Command command = program.add_command("sequence", "step a control program through a log of state estimates");
  const auto options = std::make_shared<SequenceOptions>();
  command.add_option("PROGRAM", options->program, "a .rmpl control program, or a compiled .json").required();
  command.add_option("PLANT", options->plant, "a plant model: .tcca, or a compiled .json");
  command.add_option("--log", options->log, "state estimates; - is standard input").required().option_text("IN.jsonl");
  command
      .add_option("--main", options->main, "the definition to run, if there are several that no other definition calls")
      .option_text("NAME");
  command.footer(sequence_footer);
  program.add({command, [options, &common = program.common()] { return run(*options, common); }});
}

}  // namespace rmpl::tools
