// Importing a netlist or a fault tree by its ending, or by how it begins.
// SPDX-License-Identifier: MIT
#include "compiler/import/import.hpp"

#include <filesystem>

#include "base/error.hpp"
#include "compiler/import/fault_tree.hpp"
#include "compiler/import/xmpl.hpp"
#include "compiler/session/provider.hpp"

namespace rmpl::compiler {
namespace {

/// What is imported.
enum class Format { bench, xml, galileo };

/// By the name of the file, or of standard input by how it begins.
Format format_of(const std::string& path, std::string_view text) {
  if (path == "-") {
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (first != std::string_view::npos && text[first] == '<') return Format::xml;
    return text.find("toplevel") != std::string_view::npos ? Format::galileo : Format::bench;
  }
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".bench") return Format::bench;
  if (ending == ".xml") return Format::xml;
  if (ending == ".dft") return Format::galileo;
  throw base::InputError("'" + path +
                         "' is no netlist and no fault tree: expected a file that ends in .bench, .xml, .dft, .xmpl "
                         "or .l2");
}

bool is_open_psa(std::string_view text) { return text.find("<opsa-mef") != std::string_view::npos; }

}  // namespace

ImportedPlant import_plant(const std::string& path, FaultModel faults) {
  if (path != "-") format_of(path, {});  // a wrong name is told before the file is read
  ImportedPlant result;
  auto& [sources, diagnostics] = result.findings;
  const std::uint32_t file = sources.add(path == "-" ? "<stdin>" : path, Disk().read(path));
  const std::string_view text = sources[file].text();
  const Format format = format_of(path, text);
  if (format == Format::galileo || (format == Format::xml && is_open_psa(text))) {
    const auto tree = format == Format::galileo ? read_galileo(sources, file, diagnostics)
                                                : read_open_psa(sources, file, diagnostics);
    if (tree) result.plant = to_tcca(*tree);
    return result;
  }
  auto netlist =
      format == Format::xml ? read_catalogue(sources, file, diagnostics) : read_bench(sources, file, diagnostics);
  if (!netlist) return result;
  if (netlist->name.empty()) netlist->name = path == "-" ? "circuit" : std::filesystem::path(path).stem().string();
  result.plant = to_tcca(*netlist, faults);
  return result;
}

bool is_livingstone(const std::string& path) {
  const std::filesystem::path ending = std::filesystem::path(path).extension();
  return ending == ".xmpl" || ending == ".l2";
}

ImportedPlant import_livingstone(const std::string& path) {
  ImportedPlant result;
  auto& [sources, diagnostics] = result.findings;
  XmplModel model;
  const bool compiled = std::filesystem::path(path).extension() == ".l2";
  const std::uint32_t file = sources.add(path, Disk().read(path));
  bool whole = compiled ? read_l2(sources, file, model, diagnostics) : read_xmpl(sources, file, model, diagnostics);
  for (const char* ending : {".hrn", ".ini"}) {
    const std::filesystem::path beside = std::filesystem::path(path).replace_extension(ending);
    if (compiled || !std::filesystem::exists(beside)) continue;
    whole = read_xmpl(sources, sources.add(beside.string(), Disk().read(beside.string())), model, diagnostics) && whole;
  }
  if (!whole) return result;
  if (model.name.empty()) model.name = std::filesystem::path(path).stem().string();
  if (model.components.empty()) {
    diagnostics.error(grammar::Code::netlist_syntax, {0, 0, 0}, "the model has no component");
    return result;
  }
  result.plant = to_tcca(model, diagnostics);
  if (diagnostics.has_errors()) result.plant.reset();
  return result;
}

}  // namespace rmpl::compiler
