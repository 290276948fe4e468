// Netlists as automata, for the benchmarks of diagnosis.
// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "compiler/import/import.hpp"
#include "compiler/session/compiler.hpp"
#include "grammar/source/render.hpp"

namespace rmpl::bench {

/// Imports and compiles a netlist, as `rmplc import` and the reader of every program do.
inline automata::Document imported(const std::filesystem::path& netlist, compiler::FaultModel faults) {
  const auto model = std::filesystem::temp_directory_path() / (std::to_string(getpid()) + "_circuit.tcca");
  const compiler::ImportedPlant circuit = compiler::import_plant(netlist, faults);
  if (!circuit.plant) {
    std::fputs(grammar::render_text(circuit.findings, false).c_str(), stderr);
    std::exit(EXIT_FAILURE);
  }
  std::ofstream(model) << *circuit.plant;
  const std::string path = model;
  const compiler::Compilation compilation = compiler::compile(std::span(&path, 1));
  std::filesystem::remove(model);
  if (!compilation.ok()) {
    std::fputs(grammar::render_text(compilation.findings(), false).c_str(), stderr);
    std::exit(EXIT_FAILURE);
  }
  return compilation.document();
}

}  // namespace rmpl::bench
