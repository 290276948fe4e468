// Reading what the command line names.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/input.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "base/error.hpp"
#include "grammar/source/render.hpp"

namespace rmpl::runtime {
namespace {

using base::InputError;

bool wants_color(Color color, int descriptor) {
  switch (color) {
    case Color::always:
      return true;
    case Color::never:
      return false;
    case Color::automatic:
      return isatty(descriptor) != 0 && std::getenv("NO_COLOR") == nullptr;
  }
  return false;
}

}  // namespace

bool Common::color_output() const { return wants_color(color, STDOUT_FILENO); }
bool Common::color_errors() const { return wants_color(color, STDERR_FILENO); }

std::optional<compiler::Compilation> load(const std::vector<std::string>& paths, const Common& common,
                                          const compiler::Options& options) {
  compiler::Compilation compilation = compiler::compile(paths, options);
  if (!compilation.ok() || !common.quiet) {
    std::cerr << grammar::render_text(compilation.findings(), common.color_errors());
  }
  if (!compilation.ok()) return std::nullopt;
  return compilation;
}

const automata::Plant& only_plant(const automata::Document& document, const std::string& path) {
  if (document.plants.empty()) throw base::InputError(path + ": expected a plant model, and there is none in it");
  return document.plants.front();
}

const automata::Program& only_program(const automata::Document& document, const std::string& path) {
  if (document.programs.empty()) throw base::InputError(path + ": expected a control program, and there is none in it");
  return document.programs.front();
}

std::optional<automata::Formula> formula_option(const std::string& text, const automata::Plant& plant,
                                                std::string_view where, const Common& common) {
  auto compiled = compiler::compile_formula(text, plant, where);
  std::cerr << grammar::render_text(compiled.findings, common.color_errors());
  return std::move(compiled.formula);
}

std::optional<std::vector<automata::Assignment>> assignments_option(const std::string& text,
                                                                    const automata::Plant& plant,
                                                                    std::string_view where, const Common& common) {
  auto compiled = compiler::compile_assignments(text, plant, where);
  std::cerr << grammar::render_text(compiled.findings, common.color_errors());
  if (!compiled.assignments) return std::nullopt;
  auto& assignments = *compiled.assignments;
  std::sort(assignments.begin(), assignments.end());
  assignments.erase(std::unique(assignments.begin(), assignments.end()), assignments.end());
  const auto twice = std::adjacent_find(assignments.begin(), assignments.end(),
                                        [](const auto& a, const auto& b) { return a.variable == b.variable; });
  if (twice != assignments.end()) {
    throw base::InputError(std::string(where) + ": '" + plant.variables.name(twice->variable) +
                           "' is given two values, '" + plant.variables.value(*twice) + "' and '" +
                           plant.variables.value(*(twice + 1)) + "'");
  }
  return std::move(compiled.assignments);
}

TextInput::TextInput(const std::string& path) : name_(path == "-" ? "standard input" : path), stream_(&std::cin) {
  if (path == "-") return;
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  // A directory opens, and fails when it is read.
  if (!*file || (file->peek() == std::ifstream::traits_type::eof() && file->bad())) {
    throw base::InputError(path + ": cannot be read");
  }
  file->clear();
  file_ = std::move(file);
  stream_ = file_.get();
}

void check_standard_input(const std::vector<std::string>& paths) {
  if (std::count(paths.begin(), paths.end(), "-") > 1) {
    throw base::InputError("'-' stands for standard input, which can be read only once");
  }
}

void finish_output() {
  std::cout.flush();
  if (!std::cout) throw base::InputError("standard output could not be written in full");
}

}  // namespace rmpl::runtime
