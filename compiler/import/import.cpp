// Importing a netlist by its ending, or by how it begins.
// SPDX-License-Identifier: MIT
#include "compiler/import/import.hpp"

#include <filesystem>

#include "base/error.hpp"
#include "compiler/session/provider.hpp"

namespace rmpl::compiler {
namespace {

/// Whether the text is XML: by the name of its file, or of standard input by its first character.
bool is_catalogue(const std::string& path, std::string_view text) {
  if (path == "-") {
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string_view::npos && text[first] == '<';
  }
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".bench" || ending == ".xml") return ending == ".xml";
  throw base::InputError("'" + path + "' is no netlist: expected a file that ends in .bench or .xml");
}

}  // namespace

ImportedCircuit import_circuit(const std::string& path, FaultModel faults) {
  if (path != "-") is_catalogue(path, {});  // a wrong name is told before the file is read
  ImportedCircuit result;
  auto& [sources, diagnostics] = result.findings;
  const std::uint32_t file = sources.add(path == "-" ? "<stdin>" : path, Disk().read(path));
  auto netlist = is_catalogue(path, sources[file].text()) ? read_catalogue(sources, file, diagnostics)
                                                          : read_bench(sources, file, diagnostics);
  if (!netlist) return result;
  if (netlist->name.empty()) netlist->name = path == "-" ? "circuit" : std::filesystem::path(path).stem().string();
  result.plant = to_tcca(*netlist, faults);
  return result;
}

}  // namespace rmpl::compiler
