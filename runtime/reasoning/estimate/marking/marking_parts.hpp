// Markings of a whole model program, and what they entail, from those of its groups.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "automata/dependencies/marking_groups.hpp"
#include "automata/step/program_rules.hpp"

namespace rmpl::runtime {

/// `parts`: by group, composites included.
inline automata::Marking joined(const automata::MarkingGroups& groups,
                                const std::vector<const automata::Marking*>& parts) {
  automata::Marking result;
  for (std::size_t g = 0; g < parts.size(); ++g) {
    for (const automata::LocationId l : *parts[g]) result.push_back(groups[g].locations[l.index()]);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// What the groups' markings entail of the whole program's variables.
inline std::vector<automata::Assignment> joined(const automata::MarkingGroups& groups,
                                                const std::vector<const std::vector<automata::Assignment>*>& parts) {
  std::vector<automata::Assignment> result = groups.always();
  for (std::size_t g = 0; g < parts.size(); ++g) {
    for (const automata::Assignment& a : *parts[g])
      result.push_back({groups[g].variables[a.variable.index()], a.value});
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace rmpl::runtime
