// rmplc: compiles control programs, plant models and scenarios; explains diagnostics.
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "automata/command_line.hpp"
#include "automata/error.hpp"
#include "automata/json/document.hpp"
#include "automata/size.hpp"
#include "compiler/compiler.hpp"
#include "compiler/import/import.hpp"
#include "compiler/write_file.hpp"
#include "grammar/source/codes.hpp"

namespace {

constexpr int done = 0;
constexpr int wrong_input = 2;

struct Settings {
  std::vector<std::string> files;
  std::string output;
  std::string main;
  std::string format = "text";
  std::string color = "auto";
  std::string code;
  std::string circuit;
  std::string faults = "weak";
  bool quiet = false;
  bool verbose = false;

  [[nodiscard]] compiler::DiagnosticFormat style() const {
    return format == "json" ? compiler::DiagnosticFormat::json : compiler::DiagnosticFormat::text;
  }
  [[nodiscard]] bool colored() const {
    if (color == "auto") return isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
    return color == "always";
  }
};

[[noreturn]] void refuse_to_overwrite(const std::string& input) {
  throw automata::InputError("the output would overwrite its input, " + input);
}

void finish_output() {
  if (!std::cout.flush()) throw automata::InputError("standard output: cannot be written");
}

/// Without an output, or to `-`: to standard output.
void write(const Settings& settings, const std::string& text) {
  if (!settings.output.empty() && settings.output != "-") return compiler::write_file(settings.output, text);
  std::cout << text;
  finish_output();
}

int import(const Settings& settings) {
  const auto faults = settings.faults == "strong" ? compiler::FaultModel::strong : compiler::FaultModel::weak;
  const auto imported = compiler::import_circuit(settings.circuit, faults, settings.colored());
  std::cerr << imported.diagnostics;
  if (!imported.plant) return wrong_input;
  std::error_code missing;
  if (std::filesystem::equivalent(settings.output, settings.circuit, missing)) refuse_to_overwrite(settings.circuit);
  write(settings, *imported.plant);
  return done;
}

int compile(const Settings& settings) {
  const compiler::Compilation result = compiler::compile(settings.files, {settings.main});
  if (!result.ok() || !settings.quiet) {
    std::cerr << result.diagnostics(settings.style(), settings.colored());
  }
  if (!result.ok()) return wrong_input;
  const automata::Document& document = result.document();
  if (const auto input = result.input_at(settings.output)) refuse_to_overwrite(*input);
  write(settings, automata::to_text(document));
  if (settings.verbose) {
    std::cerr << "plants: " << document.plants.size() << ", programs: " << document.programs.size()
              << ", scenarios: " << document.scenarios.size() << "\n";
    for (const automata::Plant& plant : document.plants) {
      const automata::PlantSize size = automata::size_of(plant);
      std::cerr << "plant " << plant.name << ": " << size.components << " components, " << size.modes << " modes, "
                << size.propositions << " propositions, " << size.clauses << " clauses\n";
    }
  }
  return done;
}

int explain(const Settings& settings) {
  const auto code = grammar::find_code(settings.code);
  if (!code) throw automata::InputError("'" + settings.code + "' is no code of a diagnostic, expected one as RMPL0100");
  const grammar::CodeInfo& info = grammar::info(*code);
  const auto indented = [](std::string_view text) {
    std::string result = "  ";
    for (const char c : text) result += c == '\n' ? std::string("\n  ") : std::string(1, c);
    return result;
  };
  std::cout << grammar::to_string(*code) << ": " << info.title << "\n\n"
            << info.explanation << "\n\nwrong:\n"
            << indented(info.wrong) << "\n\nright:\n"
            << indented(info.right) << "\n";
  finish_output();
  return done;
}

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
    if (importing->parsed()) return import(settings);
    return compiling->parsed() ? compile(settings) : explain(settings);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // help or version
      app.exit(error);
      return std::cout.flush() ? done : wrong_input;
    }
    std::cerr << automata::complaint(app, error);
    return wrong_input;
  } catch (const automata::InputError& error) {
    std::cerr << "rmplc: " << error.what() << "\n";
    return wrong_input;
  }
}
