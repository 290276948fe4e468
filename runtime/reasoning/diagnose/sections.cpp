// Sections: dominators on a circuit turned around.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/sections.hpp"

namespace rmpl::runtime {

Sections sections_of(const Circuit& circuit, const std::vector<bool>& observed) {
  const std::size_t count = circuit.gates.size();
  const std::size_t sink = count;
  const std::size_t unseen = count + 1;
  std::vector<std::vector<std::size_t>> readers(circuit.nets);
  for (std::size_t g = 0; g < count; ++g) {
    for (const NetId input : circuit.gates[g].inputs) readers[input].push_back(g);
  }
  // Dominators of g are met walking up from g; a gate's dominator comes later in topological order, the sink last.
  std::vector<std::size_t> dominator(count + 1, unseen);
  dominator[sink] = sink;
  const auto common = [&](std::size_t a, std::size_t b) {
    while (a != b) (a < b ? a : b) = dominator[a < b ? a : b];
    return a;
  };
  for (std::size_t g = count; g-- > 0;) {
    const NetId output = circuit.gates[g].output;
    std::size_t meet = observed[output] ? sink : unseen;
    for (const std::size_t reader : readers[output]) {
      if (dominator[reader] == unseen) continue;
      meet = meet == unseen ? reader : common(meet, reader);
    }
    dominator[g] = meet;
  }
  Sections sections{std::vector<std::optional<std::size_t>>(count), std::vector<std::vector<std::size_t>>(count)};
  for (std::size_t g = count; g-- > 0;) {
    if (dominator[g] == unseen) continue;
    sections.top[g] = dominator[g] == sink ? g : *sections.top[dominator[g]];
  }
  for (std::size_t g = 0; g < count; ++g) {
    if (sections.top[g]) sections.members[*sections.top[g]].push_back(g);
  }
  return sections;
}

}  // namespace rmpl::runtime
