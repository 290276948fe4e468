// What the untimed transitions of a goal state do to the goal.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/lasting.hpp"

#include <algorithm>
#include <utility>

#include "runtime/reasoning/reconfigure/aftermath.hpp"

namespace rmpl::runtime {

using automata::ComponentId;

namespace {

/// A component, and those that the guard of its transition reads.
std::vector<ComponentId> behind(ComponentId component, const automata::Transition& t, const automata::PlantStep& step) {
  std::vector<ComponentId> blamed = step.locality().support_of(t.guard).components;
  blamed.push_back(component);
  std::sort(blamed.begin(), blamed.end());
  blamed.erase(std::unique(blamed.begin(), blamed.end()), blamed.end());
  return blamed;
}

/// The same some untimed steps later: those that moved, and what their guards read.
std::optional<std::vector<ComponentId>> undone_later(const automata::Modes& state, const Goal& goal,
                                                     automata::PlantStep& step, GoalInterpreter& interpreter) {
  std::vector<ComponentId> all;
  for (std::size_t c = 0; c < state.size(); ++c) all.emplace_back(c);
  std::vector<ComponentId> blamed;
  for (const Consequence& next : aftermath(state, all, step)) {
    for (const TransitionOf& move : next.moves) {
      const auto& t = step.plant()[move.component].transitions[move.transition.index()];
      const std::vector<ComponentId> more = behind(move.component, t, step);
      blamed.insert(blamed.end(), more.begin(), more.end());
    }
    if (interpreter.entailed(next.modes, goal)) continue;
    std::sort(blamed.begin(), blamed.end());
    blamed.erase(std::unique(blamed.begin(), blamed.end()), blamed.end());
    return blamed;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<ComponentId>> undone_by_itself(automata::Modes state, const std::vector<bool>& wanted,
                                                         const Goal& goal, automata::PlantStep& step,
                                                         GoalInterpreter& interpreter) {
  const automata::ControlAction idle = idle_action(step.plant());
  if (!step.possible(state) || !step.permits(state, idle)) return std::nullopt;
  for (std::size_t c = 0; c < state.size(); ++c) {
    if (!wanted[c]) continue;
    const ComponentId component(c);
    for (const automata::TransitionId id : step.enabled(component, state, idle).untimed) {
      const automata::Transition& t = step.plant()[component].transitions[id.index()];
      if (t.to == t.from) continue;
      const automata::ModeId here = std::exchange(state[c], t.to);
      const bool kept = interpreter.entailed(state, goal);
      state[c] = here;
      if (!kept) return behind(component, t, step);
    }
  }
  return undone_later(state, goal, step, interpreter);
}

std::vector<ComponentId> left_by_itself(const automata::Modes& state, ComponentId component,
                                        automata::PlantStep& step) {
  const automata::ControlAction idle = idle_action(step.plant());
  if (!step.possible(state) || !step.permits(state, idle)) return {};
  const automata::Enabled& enabled = step.enabled(component, state, idle);
  for (const auto* transitions : {&enabled.untimed, &enabled.timed}) {
    for (const automata::TransitionId id : *transitions) {
      const automata::Transition& t = step.plant()[component].transitions[id.index()];
      if (t.to != t.from) return behind(component, t, step);
    }
  }
  return {};
}

std::optional<automata::Modes> rested_on(const automata::Modes& modes, const automata::Modes& end,
                                         automata::PlantStep& step) {
  automata::Modes ground = modes;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (modes[c] == end[c]) continue;
    automata::Modes alone = modes;
    alone[c] = end[c];
    for (const ComponentId b : left_by_itself(alone, ComponentId(c), step)) {
      if (b != ComponentId(c)) ground[b.index()] = end[b.index()];
    }
  }
  return ground == modes ? std::nullopt : std::optional(std::move(ground));
}

}  // namespace rmpl::runtime
