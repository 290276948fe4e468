// Where a run may start.
// SPDX-License-Identifier: MIT
#include "verifier/witness/start.hpp"

#include <algorithm>

namespace rmpl::verifier {

std::optional<std::string> wrong_start(automata::PlantStep& step, const automata::Modes& modes,
                                       const std::vector<automata::Assignment>& from) {
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const automata::Component& component = step.plant().components[c];
    const auto given = std::find_if(from.begin(), from.end(),
                                    [&](const automata::Assignment& a) { return a.variable == component.mode; });
    const bool right =
        given == from.end() ? component.initial[modes[c].index()] > 0 : given->value.value == modes[c].value;
    if (!right) return component.name + " does not start so";
  }
  if (!step.possible(modes)) return "it starts in an impossible state";
  return std::nullopt;
}

}  // namespace rmpl::verifier
