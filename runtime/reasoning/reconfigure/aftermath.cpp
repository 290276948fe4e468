// One untimed step after the other.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/aftermath.hpp"

#include <utility>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Modes;

std::vector<Consequence> aftermath(Modes modes, std::span<const ComponentId> components, automata::PlantStep& step) {
  constexpr std::size_t most_steps = 16;
  const automata::ControlAction idle = idle_action(step.plant());
  std::vector<Consequence> result;
  while (result.size() < most_steps && step.permits(modes, idle)) {
    Consequence next{modes, {}};
    for (const ComponentId c : components) {
      const automata::Enabled& enabled = step.enabled(c, modes, idle);
      if (enabled.untimed.empty()) continue;
      const automata::Transition& t = step.plant()[c].transitions[enabled.untimed.front().index()];
      if (t.to == t.from) continue;
      next.modes[c.index()] = t.to;
      next.moves.push_back({c, enabled.untimed.front()});
    }
    if (next.moves.empty() || !step.possible(next.modes)) break;
    modes = next.modes;
    result.push_back(std::move(next));
  }
  return result;
}

}  // namespace rmpl::runtime
