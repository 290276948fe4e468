// Graphviz lays out: its program `dot`, run as a process.
// SPDX-License-Identifier: MIT
#include "tools/shared/graphviz.hpp"

#include "base/error.hpp"
#include "tools/shared/child_process.hpp"

namespace rmpl::tools {

std::string svg_of(const std::string& graph, std::string_view way_out) { return picture_of(graph, "svg", way_out); }

std::string picture_of(const std::string& graph, const std::string& form, std::string_view way_out) {
  std::optional<ChildEnd> end = run_child({{"dot", "-T" + form}, graph});
  if (!end) throw base::InputError("dot, the layout program of Graphviz, is not installed: " + std::string(way_out));
  if (end->status == 0) return std::move(end->output);
  throw base::InputError("dot, the layout program of Graphviz, failed: " + end->errors);
}

}  // namespace rmpl::tools
