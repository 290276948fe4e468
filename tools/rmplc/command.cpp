// What rmplc does: compile, import, explain.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/command.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string_view>

#include "automata/json/document.hpp"
#include "automata/size.hpp"
#include "base/error.hpp"
#include "base/output_file.hpp"
#include "compiler/import/import.hpp"
#include "grammar/source/codes.hpp"
#include "grammar/source/render.hpp"

namespace rmpl::compiler {
namespace {

[[noreturn]] void refuse_to_overwrite(const std::string& input) {
  throw base::InputError("the output would overwrite its input, " + input);
}

void finish_output() {
  if (!std::cout.flush()) throw base::InputError("standard output: cannot be written");
}

/// Without an output, or to `-`: to standard output.
void write(const Settings& settings, const std::string& text) {
  if (!settings.output.empty() && settings.output != "-") return base::write_file(settings.output, text);
  std::cout << text;
  finish_output();
}

/// Nothing where there is nothing to say, in JSON too.
std::string rendered(const grammar::Findings& findings, const Settings& settings) {
  if (findings.diagnostics.empty()) return {};
  return settings.format == "json" ? grammar::render_json(findings)
                                   : grammar::render_text(findings, settings.colored());
}

}  // namespace

bool Settings::colored() const {
  if (color == "auto") return isatty(STDERR_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
  return color == "always";
}

int run_import(const Settings& settings) {
  const auto faults = settings.faults == "strong" ? FaultModel::strong : FaultModel::weak;
  const auto imported = import_circuit(settings.circuit, faults);
  std::cerr << grammar::render_text(imported.findings, settings.colored());
  if (!imported.plant) return wrong_input;
  std::error_code missing;
  if (std::filesystem::equivalent(settings.output, settings.circuit, missing)) refuse_to_overwrite(settings.circuit);
  write(settings, *imported.plant);
  return done;
}

int run_compile(const Settings& settings) {
  const Compilation result = compile(settings.files, {settings.main});
  if (!result.ok() || !settings.quiet) {
    std::cerr << rendered(result.findings(), settings);
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

int run_explain(const Settings& settings) {
  const auto code = grammar::find_code(settings.code);
  if (!code) throw base::InputError("'" + settings.code + "' is no code of a diagnostic, expected one as RMPL0100");
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

}  // namespace rmpl::compiler
