// Fuzzes the reader of ISCAS netlists: it refuses with a message, or writes a plant.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "compiler/import/netlist.hpp"
#include "grammar/source/render.hpp"

using namespace rmpl;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  grammar::Sources sources;
  grammar::Diagnostics diagnostics;
  const auto file = sources.add("circuit", std::string(reinterpret_cast<const char*>(data), size));
  const auto netlist = compiler::read_bench(sources, file, diagnostics);
  if (netlist.has_value() == diagnostics.has_errors()) std::abort();
  if (!netlist) {
    if (grammar::render_text(diagnostics.sorted(), sources, false).empty()) std::abort();
    return 0;
  }
  try {
    if (compiler::to_tcca(*netlist, compiler::FaultModel::strong).empty()) std::abort();
  } catch (const base::InputError& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
  return 0;
}
