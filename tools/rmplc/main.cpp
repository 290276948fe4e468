// rmplc: compiles control programs, plant models and scenarios; explains diagnostics.
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <new>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/out_of_memory.hpp"
#include "tools/rmplc/command.hpp"
#include "tools/shared/complaint.hpp"

using namespace rmpl;

namespace {

using compiler::Settings;

constexpr const char* compile_notes =
    R"(Writes one self-contained JSON document to standard output, or to OUT.json with -o:
the plant, the control program (checked against the plant and bound to it, where
both are given) and the scenarios with what they refer to. The same input gives the
same bytes. A failed compile writes nothing.

Files are told by their names: .rmpl control programs, .tcca plant models, .scn
scenarios, .json compiled documents. `-` is standard input, told by its content.
Imports are relative to the importing file.

Example:
  rmplc compile mars_entry.rmpl mars_lander.tcca -o mars_entry.json)";

constexpr const char* import_notes =
    R"(Writes a plant: one instance a gate, named as in the file; ports are observed.
weak:   a gate is ok or faulty, and a faulty one does anything
strong: ok, stuck-at-0, stuck-at-1 or unknown, with 0.099, 0.099 and 0.002

Example:
  rmplc import c17.bench --faults weak -o c17.tcca)";

constexpr const char* exit_codes = R"(Exit status:
  0  done
  2  the command line or an input is wrong; nothing was written
  3  out of memory; nothing was written

Examples:
  rmplc compile mars_entry.rmpl mars_lander.tcca -o mars_entry.json
  rmplc compile --main EntrySequence edl.rmpl
  rmplc explain RMPL0301)";

void common_options(CLI::App& app, Settings& settings) {
  app.add_option("--color", settings.color, "Color diagnostics: auto (on a terminal), always, never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
  app.add_flag("-q", settings.quiet, "Print errors only");
  app.add_flag("-v", settings.verbose, "Say what was compiled");
}

}  // namespace

int main(int argc, char** argv) {
  std::set_terminate([] { base::end_for_lack_of_memory("rmplc"); });
  CLI::App app{"The RMPL compiler: control programs, plant models and scenarios become automata.", "rmplc"};
  app.set_version_flag("--version", "rmplc " RMPL_VERSION);
  app.footer(exit_codes);
  app.require_subcommand(1);
  app.fallthrough();
  Settings settings;
  common_options(app, settings);

  CLI::App* compiling = app.add_subcommand("compile", "Compile sources into one JSON document");
  compiling->footer(compile_notes);
  compiling->add_option("FILE", settings.files, "Sources and compiled documents")->required();
  compiling->add_option("-o,--output", settings.output, "Write the document to this file")->type_name("OUT.json");
  compiling->add_option("--main", settings.main, "Start the control program at this definition")->type_name("NAME");
  compiling->add_option("--format", settings.format, "Diagnostics as text or json")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();

  CLI::App* explaining = app.add_subcommand("explain", "Tell what a diagnostic means, with an example");
  explaining->add_option("CODE", settings.code, "As in the diagnostic: RMPL0301")->required();

  CLI::App* importing = app.add_subcommand("import", "Turn a circuit into a plant model");
  importing->footer(import_notes);
  importing
      ->add_option("FILE", settings.circuit,
                   "A netlist: .bench, or .xml of the diagnostic competition; - is standard input")
      ->required();
  importing->add_option("-o,--output", settings.output, "Write the plant to this file")->type_name("OUT.tcca");
  importing->add_option("--faults", settings.faults, "How gates fail: weak or strong")
      ->check(CLI::IsMember({"weak", "strong"}))
      ->capture_default_str();

  try {
    app.parse(argc, argv);
    if (importing->parsed()) return compiler::run_import(settings);
    return compiling->parsed() ? compiler::run_compile(settings) : compiler::run_explain(settings);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // help or version
      app.exit(error);
      return std::cout.flush() ? compiler::done : compiler::wrong_input;
    }
    std::cerr << automata::complaint(app, error);
    return compiler::wrong_input;
  } catch (const base::InputError& error) {
    std::cerr << "rmplc: " << error.what() << "\n";
    return compiler::wrong_input;
  } catch (const base::InternalError& error) {
    std::cerr << "rmplc: internal error, nothing is claimed: " << error.what() << "\n";
    return 4;
  } catch (const std::bad_alloc&) {
    std::cerr << "rmplc: out of memory\n";
    return compiler::limit_hit;
  }
}
