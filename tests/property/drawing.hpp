// DOT as our diagrams write it, a statement a line, read back: what stands in it, where, and how often.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <regex>
#include <sstream>
#include <string>
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

inline Drawing read_drawing(const std::string& text) {
  static const std::regex edge(R"(^\s*([\w:]+) -> ([\w:]+)( \[id=(\w+).*)?( \[.*)?;$)");
  static const std::regex node(R"(^\s*(\w+) \[.*;$)");
  static const std::regex cluster(R"(^\s*subgraph cluster_(\w+) \{$)");
  static const std::regex end(R"(^\s*\}$)");
  Drawing drawing;
  std::vector<std::string> open{"graph"};
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::smatch match;
    const std::vector<std::string> around(open.begin(), open.end());
    if (std::regex_match(line, match, cluster)) {
      drawing.once = drawing.once && drawing.clusters.emplace(match[1], around).second;
      open.push_back(match[1]);
    } else if (std::regex_match(line, match, end)) {
      drawing.closed = open.size() == 1 && lines.peek() == std::istringstream::traits_type::eof();
      if (!open.empty()) open.pop_back();
    } else if (std::regex_match(line, match, edge)) {
      drawing.edges[match[4]].push_back({match[1], match[2]});
    } else if (std::regex_match(line, match, node) && match[1] != "node" && match[1] != "edge") {
      drawing.once = drawing.once && drawing.nodes.emplace(match[1], around).second;
    }
  }
  return drawing;
}

}  // namespace rmpl::property
