// What a program has achieved by its goals, and what a command takes away that no goal asks for.
// SPDX-License-Identifier: MIT
#include "verifier/witness/undone.hpp"

#include <algorithm>

namespace rmpl::verifier {

using automata::Assignment;
using automata::ComponentId;
using automata::ModeId;
using automata::Modes;

namespace {

/// The mode that a goal asks of a component.
std::optional<ModeId> asked_of(const automata::Component& component, const std::vector<Assignment>& goal) {
  const auto at =
      std::find_if(goal.begin(), goal.end(), [&](const Assignment& a) { return a.variable == component.mode; });
  return at == goal.end() ? std::nullopt : std::optional(ModeId(at->value.index()));
}

/// Whether one of the nominal transitions that are enabled with all controls idle leads to the mode, at whatever time.
bool leads(const automata::Component& component, const automata::Enabled& idle, ModeId to) {
  const auto to_it = [&](automata::TransitionId id) { return component.transitions[id.index()].to == to; };
  return std::any_of(idle.untimed.begin(), idle.untimed.end(), to_it) ||
         std::any_of(idle.timed.begin(), idle.timed.end(), to_it);
}

/// `comes_anyway` says whether a component would come to its new mode with all controls idle.
template <class ComesAnyway>
Achieved taken_away(const automata::Plant& plant, const Achieved& achieved, const CycleTaken& cycle,
                    const ComesAnyway& comes_anyway) {
  Achieved result;
  if (cycle.purpose != runtime::Reason::Purpose::reward) return result;
  for (const ComponentId c : achieved) {
    const ModeId from = cycle.from[c.index()];
    const ModeId to = cycle.to[c.index()];
    const auto asked = asked_of(plant[c], cycle.goal);
    if (from == to || (asked && *asked != from) || plant[c].modes[to.index()].fault) continue;
    if (!comes_anyway(c, to)) result.push_back(c);
  }
  return result;
}

}  // namespace

Achieved achieved_after(const automata::Plant& plant, const Achieved& before, const std::vector<Assignment>& goal,
                        const Modes& from, const Modes& to) {
  Achieved result;
  for (std::size_t c = 0; c < to.size(); ++c) {
    const bool kept = from[c] == to[c] && std::binary_search(before.begin(), before.end(), ComponentId(c));
    if (kept || asked_of(plant.components[c], goal) == to[c]) result.emplace_back(c);
  }
  return result;
}

Achieved taken_away(automata::PlantStep& step, const Achieved& achieved, const CycleTaken& cycle) {
  const automata::ControlAction idle = automata::idle_action(step.plant());
  return taken_away(step.plant(), achieved, cycle, [&](ComponentId c, ModeId to) {
    return step.consistent(cycle.from, idle) && leads(step.plant()[c], step.enabled(c, cycle.from, idle), to);
  });
}

Achieved taken_away(automata::PlainStep& rules, const Achieved& achieved, const CycleTaken& cycle) {
  const automata::ControlAction idle = automata::idle_action(rules.plant());
  return taken_away(rules.plant(), achieved, cycle, [&](ComponentId c, ModeId to) {
    return rules.store().consistent(cycle.from, idle) &&
           leads(rules.plant()[c], rules.enabled(cycle.from, idle)[c.index()], to);
  });
}

std::optional<Undone> undone_at_end(automata::PlainStep& rules, const Witness& witness) {
  const std::vector<Event>& events = witness.events;
  if (events.size() < 3) return std::nullopt;
  Achieved achieved;
  for (std::size_t e = 1; e + 2 < events.size(); ++e) {
    achieved =
        achieved_after(rules.plant(), achieved, events[e].cycle->goals.goal, events[e - 1].modes, events[e].modes);
  }
  const std::size_t last = events.size() - 2;
  const Cycle& cycle = *events[last].cycle;
  const Modes& from = events[last - 1].modes;
  const Achieved taken =
      taken_away(rules, achieved, {cycle.goals.goal, cycle.why.purpose, events[last].action, from, events[last].modes});
  if (taken.empty()) return std::nullopt;
  const ComponentId component = taken.front();
  const ModeId mode = from[component.index()];
  std::size_t asked = last - 1;
  while (asked_of(rules.plant()[component], events[asked].cycle->goals.goal) != mode) --asked;
  return Undone{component, mode, asked};
}

}  // namespace rmpl::verifier
