// What the commands of tcca-check read.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/input.hpp"

#include <unistd.h>

#include <iostream>

#include "base/error.hpp"
#include "grammar/source/render.hpp"

namespace rmpl::verifier {

bool colored(const CommandLine& line, int stream) {
  switch (line.color) {
    case CommandLine::Color::automatic:
      return isatty(stream) != 0;
    case CommandLine::Color::always:
      return true;
    case CommandLine::Color::never:
      return false;
  }
  return false;
}

compiler::Compilation load(const CommandLine& line) {
  compiler::Options options;
  options.main = line.entry;
  compiler::Compilation compilation = compiler::compile(line.models, options);
  const bool failed = !compilation.ok();
  if (failed || !line.quiet) {
    std::cerr << grammar::render_text(compilation.findings(), colored(line, STDERR_FILENO));
  }
  if (failed) throw Rejected{};
  const std::size_t plants = compilation.document().plants.size();
  if (plants != 1) {
    std::string names;
    for (const std::string& model : line.models) names += (names.empty() ? "" : ", ") + model;
    throw base::InputError(names + ": holds " + std::to_string(plants) + " plants; expected one, as in a .tcca file");
  }
  return compilation;
}

automata::Formula formula(const std::string& text, const automata::Plant& plant, const char* option,
                          const CommandLine& line) {
  auto compiled = compiler::compile_formula(text, plant, option);
  if (compiled.formula) return *compiled.formula;
  std::cerr << grammar::render_text(compiled.findings, colored(line, STDERR_FILENO));
  throw Rejected{};
}

std::vector<automata::Assignment> starting_modes(const automata::Plant& plant, const CommandLine& line) {
  if (line.from.empty()) return {};
  auto compiled = compiler::compile_assignments(line.from, plant, "--from");
  if (compiled.assignments) return std::move(*compiled.assignments);
  std::cerr << grammar::render_text(compiled.findings, colored(line, STDERR_FILENO));
  throw Rejected{};
}

}  // namespace rmpl::verifier
