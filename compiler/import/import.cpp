// Importing a netlist by its ending.
// SPDX-License-Identifier: MIT
#include "compiler/import/import.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "automata/error.hpp"

namespace compiler {

std::string import_circuit(const std::string& path, FaultModel faults) {
  const std::filesystem::path file(path);
  const std::string ending = file.extension().string();
  if (ending != ".bench" && ending != ".xml") {
    throw automata::InputError("'" + path + "' is no netlist: expected a file that ends in .bench or .xml");
  }
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream.is_open() || stream.bad()) throw automata::InputError(path + ": cannot be read");
  Netlist netlist = ending == ".bench" ? read_bench(text, path) : read_catalogue(text, path);
  if (netlist.name.empty()) netlist.name = file.stem().string();
  return to_tcca(netlist, faults);
}

}  // namespace compiler
