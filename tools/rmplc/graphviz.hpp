// Graphviz lays out: its program `dot`, run as a process.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rmpl::tools {

/// A graph in DOT as an SVG picture. Throws base::InputError where there is no `dot`, or where it fails.
std::string svg_of(const std::string& graph);

}  // namespace rmpl::tools
