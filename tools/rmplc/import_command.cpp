// rmplc import: a circuit or a fault tree becomes a plant model.
// SPDX-License-Identifier: MIT
#include <memory>

#include "compiler/import/import.hpp"
#include "tools/rmplc/commands.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

using compiler::FaultModel;

struct ImportOptions {
  std::string file;
  std::string output;
  FaultModel faults = FaultModel::weak;
};

constexpr const char* import_notes =
    R"(Writes a plant, with the names of the file. Of a circuit, one instance a gate; ports are observed.
weak:   a gate is ok or faulty, and a faulty one does anything
strong: ok, stuck-at-0, stuck-at-1 or unknown, with 0.099, 0.099 and 0.002
Of a fault tree, one instance a basic event, and one a gate with a memory; a unit of time of a .dft is a second.

Examples:
  rmplc import c17.bench --faults weak -o c17.tcca
  rmplc import pumps.dft -o pumps.tcca
  rmplc import cb.xmpl -o cb.tcca)";

ExitStatus run(const ImportOptions& options, const Common& common) {
  const auto imported = compiler::is_livingstone(options.file) ? compiler::import_livingstone(options.file)
                                                               : compiler::import_plant(options.file, options.faults);
  tell_findings(imported.findings, common);
  if (!imported.plant) throw Rejected{};
  write_result(options.output, *imported.plant);
  return ExitStatus::done;
}

}  // namespace

void add_import(Program& program) {
  Command command = program.add_command("import", "turn a circuit, a fault tree or a Livingstone2 model into a plant");
  const auto options = std::make_shared<ImportOptions>();
  command
      .add_option(
          "FILE", options->file,
          "a netlist, .bench or .xml of the diagnostic competition, or a fault tree, .xml (Open-PSA) or .dft "
          "(Galileo), or a Livingstone2 model, .xmpl, with its .hrn and .ini beside it, or .l2; - is standard input")
      .required();
  add_output(command, options->output, "OUT.tcca", "write the plant to this file");
  add_choice<FaultModel>(command, "--faults", options->faults,
                         {{"weak", FaultModel::weak}, {"strong", FaultModel::strong}},
                         "fault model of the gates of circuits (default: weak)");
  Common& common = program.common();
  add_diagnostics_format(command, common);
  command.footer(import_notes);
  program.add({command, [options, &common] { return run(*options, common); }});
}

}  // namespace rmpl::tools
