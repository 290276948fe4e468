// What every reader of fault trees must do with any bytes: refuse them with a message, or write a plant.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "compiler/import/fault_tree.hpp"
#include "grammar/source/render.hpp"

namespace rmpl {

/// Aborts where `read`, a reader of `compiler/import`, does neither with `data`, or both.
template <class Read>
void read_as_tree(Read read, const std::uint8_t* data, std::size_t size) {
  grammar::Sources sources;
  grammar::Diagnostics diagnostics;
  const auto file = sources.add("tree", std::string(reinterpret_cast<const char*>(data), size));
  const auto tree = read(sources, file, diagnostics);
  if (tree.has_value() == diagnostics.has_errors()) std::abort();
  if (!tree) {
    if (grammar::render_text(diagnostics.sorted(), sources, false).empty()) std::abort();
    return;
  }
  try {
    if (compiler::to_tcca(*tree).empty()) std::abort();
  } catch (const base::InputError& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
}

}  // namespace rmpl
