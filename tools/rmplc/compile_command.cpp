// rmplc compile: sources become one JSON document.
// SPDX-License-Identifier: MIT
#include <memory>

#include "automata/json/document.hpp"
#include "automata/size.hpp"
#include "base/output_file.hpp"
#include "tools/rmplc/commands.hpp"
#include "tools/rmplc/project/dependencies.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

struct CompileOptions {
  std::vector<std::string> files;
  std::string output;
  std::string depfile;  ///< where to write what the output depends on; empty: nowhere
  std::string main;
};

constexpr const char* compile_notes =
    R"(Writes one self-contained JSON document to standard output, or to OUT.json with -o:
the plant, the control program (checked against the plant and bound to it, where
both are given) and the scenarios with what they refer to. The same input gives the
same bytes. A failed compile writes nothing.

Files are told by their names: .rmpl control or model programs, .tcca plants, .scn
scenarios, .json compiled documents. `-` is standard input, told by its content.
Imports are relative to the importing file.

Example:
  rmplc compile mars_entry.rmpl mars_lander.tcca -o mars_entry.json)";

void print_sizes(const automata::Document& document) {
  std::string text = "plants: " + std::to_string(document.plants.size()) +
                     ", programs: " + std::to_string(document.programs.size()) +
                     (document.models.empty() ? "" : ", model programs: " + std::to_string(document.models.size())) +
                     ", scenarios: " + std::to_string(document.scenarios.size()) + "\n";
  for (const automata::Plant& plant : document.plants) {
    const automata::PlantSize size = automata::size_of(plant);
    text += "plant " + plant.name + ": " + std::to_string(size.components) + " components, " +
            std::to_string(size.modes) + " modes, " + std::to_string(size.propositions) + " propositions, " +
            std::to_string(size.clauses) + " clauses\n";
  }
  for (const automata::ModelProgram& model : document.models) {
    text += "model program " + model.name + ": " + std::to_string(model.locations.size()) + " locations, " +
            std::to_string(model.variables.size()) + " variables\n";
  }
  print_error(text);
}

ExitStatus run(const CompileOptions& options, const Common& common) {
  const compiler::Compilation result = load(options.files, common, {options.main});
  write_result(options.output, automata::to_text(result.document()));
  if (!options.depfile.empty()) {
    std::vector<std::string> files;
    const grammar::Sources& sources = result.findings().sources;
    for (std::uint32_t file = 0; file < sources.size(); ++file) files.push_back(sources[file].name());
    base::write_file(options.depfile, dependency_rule(options.output, files));
  }
  if (common.verbose) print_sizes(result.document());
  return ExitStatus::done;
}

}  // namespace

void add_compile(Program& program) {
  Command command = program.add_command("compile", "compile sources into one JSON document");
  const auto options = std::make_shared<CompileOptions>();
  command.add_option("FILE", options->files, "sources and compiled documents").required();
  add_output(command, options->output, "OUT.json", "write the document to this file");
  command.add_option("--depfile", options->depfile, "write the files that the output depends on, for make and ninja")
      .option_text("OUT.d")
      .needs(command.option("--output"));
  command.add_option("--main", options->main, "start the control program at this definition").option_text("NAME");
  Common& common = program.common();
  add_diagnostics_format(command, common);
  command.footer(compile_notes);
  program.add({command, [options, &common] { return run(*options, common); }});
}

}  // namespace rmpl::tools
