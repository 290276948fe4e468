// Graphviz lays out: its program `dot`, run as a process.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rmpl::tools {

/// A graph in DOT as an SVG picture. Throws base::InputError where there is no `dot`, with `way_out` as what to do
/// then, or where it fails.
std::string svg_of(const std::string& graph, std::string_view way_out);

/// The same in another form that `dot` knows: `png`, `pdf`.
std::string picture_of(const std::string& graph, const std::string& form, std::string_view way_out);

}  // namespace rmpl::tools
