// DOT as our diagrams write it, a statement a line, read back: what stands in it, where, and how often.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace rmpl::property {

struct DrawnEdge {
  std::string from, to;
};

struct Drawing {
  std::map<std::string, std::vector<std::string>> nodes;     ///< by identifier, the clusters around it, once each
  std::map<std::string, std::vector<std::string>> clusters;  ///< likewise
  std::map<std::string, std::vector<DrawnEdge>> edges;       ///< by `id`; those without one by ""
  bool once = true;                                          ///< no node and no cluster is stated twice
  bool closed = false;                                       ///< every bracket is closed, and the graph ends the text
};

/// What `line` begins with that could be an identifier.
inline std::string identifier_of(std::string_view line) {
  const auto end = std::ranges::find_if_not(
      line, [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; });
  return {line.begin(), end};
}

inline Drawing read_drawing(const std::string& text) {
  static constexpr std::string_view cluster = "subgraph cluster_", arrow = " -> ", identified = "id=";
  Drawing drawing;
  std::vector<std::string> open{"graph"};
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    line.erase(0, line.find_first_not_of(' '));
    const std::vector<std::string> around(open.begin(), open.end());
    if (line.starts_with(cluster)) {
      open.push_back(identifier_of(std::string_view(line).substr(cluster.size())));
      drawing.once = drawing.once && drawing.clusters.emplace(open.back(), around).second;
    } else if (line == "}") {
      drawing.closed = open.size() == 1 && lines.peek() == std::istringstream::traits_type::eof();
      if (!open.empty()) open.pop_back();
    } else if (line.ends_with(';')) {
      const std::size_t bracket = line.find(" [");
      const std::string stated = line.substr(0, std::min(bracket, line.size() - 1));
      const std::string_view attributes =
          bracket == std::string::npos ? "" : std::string_view(line).substr(bracket + 2);
      if (const std::size_t at = stated.find(arrow); at != std::string::npos) {
        const std::string id =
            attributes.starts_with(identified) ? identifier_of(attributes.substr(identified.size())) : "";
        drawing.edges[id].push_back({stated.substr(0, at), stated.substr(at + arrow.size())});
      } else if (bracket != std::string::npos && stated == identifier_of(stated) && stated != "node" &&
                 stated != "edge") {
        drawing.once = drawing.once && drawing.nodes.emplace(stated, around).second;
      }
    }
  }
  return drawing;
}

}  // namespace rmpl::property
