// rmplc import: a circuit becomes a plant model.
// SPDX-License-Identifier: MIT
#include <memory>

#include "compiler/import/import.hpp"
#include "tools/rmplc/commands.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

using compiler::FaultModel;

struct Options {
  std::string circuit;
  std::string output;
  FaultModel faults = FaultModel::weak;
};

constexpr const char* notes =
    R"(Writes a plant: one instance a gate, named as in the file; ports are observed.
weak:   a gate is ok or faulty, and a faulty one does anything
strong: ok, stuck-at-0, stuck-at-1 or unknown, with 0.099, 0.099 and 0.002

Example:
  rmplc import c17.bench --faults weak -o c17.tcca)";

ExitStatus run(const Options& options, const Common& common) {
  const auto imported = compiler::import_circuit(options.circuit, options.faults);
  tell_findings(imported.findings, common);
  if (!imported.plant) throw Rejected{};
  write_result(options.output, *imported.plant);
  return ExitStatus::done;
}

}  // namespace

void add_import(Program& program) {
  CLI::App* command = program.app().add_subcommand("import", "turn a circuit into a plant model");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("FILE", options->circuit,
                   "a netlist: .bench, or .xml of the diagnostic competition; - is standard input")
      ->required();
  add_output(*command, options->output, "OUT.tcca", "write the plant to this file");
  add_choice<FaultModel>(*command, "--faults", options->faults,
                         {{"weak", FaultModel::weak}, {"strong", FaultModel::strong}},
                         "how gates fail (default: weak)");
  Common& common = program.common();
  add_diagnostics_format(*command, common);
  command->footer(notes);
  program.add({command, [options, &common] { return run(*options, common); }});
}

}  // namespace rmpl::tools
