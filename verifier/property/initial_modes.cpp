// The modes in which the components of a plant can start.
// SPDX-License-Identifier: MIT
#include "verifier/property/initial_modes.hpp"

#include <algorithm>
#include <set>

#include "base/error.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::ModeId;

std::vector<std::vector<ModeId>> initial_modes(const automata::Plant& plant, const std::vector<Assignment>& from) {
  std::vector<std::vector<ModeId>> result;
  for (const automata::Component& component : plant.components) {
    auto& modes = result.emplace_back();
    const auto given =
        std::find_if(from.begin(), from.end(), [&](const Assignment& a) { return a.variable == component.mode; });
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      if (given == from.end() ? component.initial[m] > 0 : given->value.index() == m) modes.emplace_back(m);
    }
  }
  return result;
}

void demand_modes(const automata::Plant& plant, const std::vector<Assignment>& from) {
  std::set<automata::VariableId> seen;
  for (const Assignment& a : from) {
    const std::string& name = plant.variables.name(a.variable);
    if (!plant.component_of(a.variable)) {
      throw base::InputError("'" + name + "' is not the mode of a component; expected a component to start from");
    }
    if (!seen.insert(a.variable).second) {
      throw base::InputError("'" + name + "' is given more than one mode to start in");
    }
  }
}

void refuse_start() {
  throw base::InputError("no state to start in is possible: the modes contradict the interconnections");
}

}  // namespace rmpl::verifier
