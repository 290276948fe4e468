// Read, parsed, lowered.
// SPDX-License-Identifier: MIT
#include "compiler/session/monitors.hpp"

#include "compiler/lower/monitor.hpp"
#include "compiler/session/provider.hpp"
#include "grammar/parse/parse_monitors.hpp"

namespace rmpl::compiler {

std::optional<std::vector<automata::Monitor>> compile_monitors(const std::string& path, const automata::Plant& plant,
                                                               grammar::Findings& findings) {
  auto& [sources, diagnostics] = findings;
  const std::size_t errors = diagnostics.error_count();
  const std::uint32_t file = sources.add(path == "-" ? "<stdin>" : path, Disk().read(path));
  const auto parsed = grammar::parse_monitors(sources, file, diagnostics);
  if (!parsed.whole) return std::nullopt;
  auto monitors = lower_monitors(sources, parsed.tree, {file, 0, 0}, plant, diagnostics);
  if (diagnostics.error_count() != errors) return std::nullopt;
  return monitors;
}

}  // namespace rmpl::compiler
