// Fuzz target: any bytes as a `.mon` file give a tree or diagnostics, and the diagnostics can be shown;
// what parses can be formatted.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "grammar/parse/parse_monitors.hpp"
#include "grammar/source/render.hpp"
#include "tests/fuzz/format_target.hpp"

using namespace rmpl;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  grammar::Sources sources;
  grammar::Diagnostics diagnostics;
  const auto file = sources.add("fuzz.mon", std::string(data, data + size));
  const auto tree = grammar::parse_monitors(sources, file, diagnostics);
  if (tree.whole == diagnostics.has_errors()) std::abort();
  grammar::render_text(diagnostics.sorted(), sources, true);
  grammar::render_json(diagnostics.sorted(), sources);
  if (tree.whole) fuzz::check_format(sources[file].text(), compiler::Kind::monitors);
  return 0;
}
