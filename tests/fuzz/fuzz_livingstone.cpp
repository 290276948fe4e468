// Fuzzes the readers of Livingstone2 models, XMPL and compiled: a plant comes out, or errors with places do.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "compiler/import/xmpl.hpp"
#include "grammar/source/render.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rmpl;
  grammar::Sources sources;
  grammar::Diagnostics diagnostics;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const bool xmpl = text.find('<') != std::string::npos;
  const std::uint32_t file = sources.add(xmpl ? "fuzz.xmpl" : "fuzz.l2", text);
  compiler::XmplModel model;
  const bool read = xmpl ? read_xmpl(sources, file, model, diagnostics) : read_l2(sources, file, model, diagnostics);
  if (read == diagnostics.has_errors()) std::abort();
  if (read && !model.components.empty()) {
    if (model.name.empty()) model.name = "fuzz";
    const auto plant = to_tcca(model, diagnostics);
    if (!diagnostics.has_errors() && (!plant || plant->empty())) std::abort();
  }
  if (diagnostics.has_errors() && grammar::render_text(diagnostics.sorted(), sources, false).empty()) std::abort();
  return 0;
}
