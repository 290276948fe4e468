// The examples, compiled, for the benchmarks to run on.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <vector>

#include "compiler/session/compiler.hpp"
#include "grammar/source/render.hpp"
#include "tests/paths.hpp"

namespace rmpl::bench {

/// Paths below examples/.
inline std::vector<std::string> example_paths(std::initializer_list<const char*> names) {
  std::vector<std::string> paths;
  for (const char* name : names) paths.push_back(rmpl::paths::source() + "/examples/" + name);
  return paths;
}

/// An example as automata. It is part of the tree: where it does not compile there is nothing to measure.
inline automata::Document example(std::initializer_list<const char*> names) {
  const compiler::Compilation compilation = compiler::compile(example_paths(names));
  if (!compilation.ok()) {
    std::fputs(grammar::render_text(compilation.findings(), false).c_str(), stderr);
    std::exit(EXIT_FAILURE);
  }
  return compilation.document();
}

/// A formula over a plant, as on the command line.
inline automata::Formula formula(const char* text, const automata::Plant& plant) {
  const auto compiled = compiler::compile_formula(text, plant, "benchmark");
  if (!compiled.formula) {
    std::fputs(grammar::render_text(compiled.findings, false).c_str(), stderr);
    std::exit(EXIT_FAILURE);
  }
  return *compiled.formula;
}

}  // namespace rmpl::bench
