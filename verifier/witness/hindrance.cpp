// Why a run waits for ever.
// SPDX-License-Identifier: MIT
#include "verifier/witness/hindrance.hpp"

#include <algorithm>
#include <set>

namespace rmpl::verifier {

using automata::ComponentId;
using automata::Modes;
using automata::Transition;
using automata::TransitionId;

namespace {

/// The components whose modes decide what the marked locations wait for.
std::set<ComponentId> awaited(const automata::PlantStep& step, const automata::Program& program, const Cycle& cycle,
                              const Modes& modes) {
  std::set<ComponentId> result;
  for (const automata::LocationId id : cycle.marking) {
    const automata::Location& location = program.locations[id.index()];
    if (location.composite) continue;
    for (const automata::Assignment& asked : location.goal) {
      const auto component = step.plant().component_of(asked.variable);
      if (component && modes[component->index()].index() != asked.value.index()) result.insert(*component);
    }
    for (const automata::Formula& constraint : location.goal_constraints) {
      const auto support = step.locality().support_of(constraint);
      result.insert(support.components.begin(), support.components.end());
    }
    for (const automata::Arc& arc : location.arcs) {
      const auto support = step.locality().support_of(arc.guard.constraint);
      if (!location.has_goal()) result.insert(support.components.begin(), support.components.end());
    }
  }
  return result;
}

/// The self-transition that leaves an enabled transition no share of any step, once all bounds have passed (semantics
/// 3): an untimed one takes all that timed ones would have, and one that is overdue all that those without an upper
/// bound would.
std::optional<TransitionId> overtakes(const automata::Component& automaton, const automata::Enabled& enabled,
                                      const Transition& transition) {
  const auto first_self = [&](const std::vector<TransitionId>& ids, auto suits) -> std::optional<TransitionId> {
    const auto at = std::find_if(ids.begin(), ids.end(), [&](TransitionId id) {
      const Transition& t = automaton.transitions[id.index()];
      return t.from == t.to && suits(t);
    });
    return at == ids.end() ? std::nullopt : std::optional(*at);
  };
  if (!transition.timing) return std::nullopt;
  if (!enabled.untimed.empty()) return first_self(enabled.untimed, [](const Transition&) { return true; });
  if (!transition.timing->upper.is_infinite()) return std::nullopt;
  return first_self(enabled.timed, [](const Transition& t) { return !t.timing->upper.is_infinite(); });
}

Hindrance hindrance_of(automata::PlantStep& step, ComponentId component, const Modes& modes,
                       const automata::ControlAction& action) {
  const automata::Component& automaton = step.plant()[component];
  const automata::ModeId mode = modes[component.index()];
  Hindrance result{Hindrance::Kind::missing, component, mode, std::nullopt};
  const automata::Enabled& enabled = step.enabled(component, modes, action);
  for (std::size_t t = 0; t < automaton.transitions.size(); ++t) {
    const Transition& transition = automaton.transitions[t];
    if (transition.from != mode || transition.to == mode || automaton.is_fault(transition)) continue;
    const auto is_this = [t](TransitionId id) { return id.index() == t; };
    const bool open = std::any_of(enabled.untimed.begin(), enabled.untimed.end(), is_this) ||
                      std::any_of(enabled.timed.begin(), enabled.timed.end(), is_this);
    // An enabled one is taken at last where some step lets it be: here none does.
    if (open) {
      const auto by = overtakes(automaton, enabled, transition);
      return {by ? Hindrance::Kind::overtaken : Hindrance::Kind::excluded, component, mode, TransitionId(t), by};
    }
    if (!result.transition) result = {Hindrance::Kind::disabled, component, mode, TransitionId(t)};
  }
  return result;
}

}  // namespace

std::vector<Hindrance> hindrances(automata::PlantStep& step, const automata::Program& program, const Witness& witness) {
  const Event& last = witness.events.back();
  std::vector<Hindrance> result;
  if (!step.consistent(last.modes, last.action)) return result;
  for (const ComponentId component : awaited(step, program, *last.cycle, last.modes)) {
    result.push_back(hindrance_of(step, component, last.modes, last.action));
  }
  return result;
}

std::string to_text(const automata::Plant& plant, const Hindrance& hindrance) {
  const automata::Component& component = plant[hindrance.component];
  const automata::Mode& mode = component.modes[hindrance.mode.index()];
  if (!hindrance.transition) {
    return "no nominal transition leads '" + component.name + "' out of '" + mode.name + "'" + in_brackets(mode.origin);
  }
  const Transition& t = component.transitions[hindrance.transition->index()];
  const std::string step = "the transition of '" + component.name + "' from '" + mode.name + "' to '" +
                           component.modes[t.to.index()].name + "'" + in_brackets(t.origin);
  switch (hindrance.kind) {
    case Hindrance::Kind::excluded:
      return step + " leads to a state that the constraints exclude";
    case Hindrance::Kind::overtaken: {
      const Transition& by = component.transitions[hindrance.by->index()];
      const std::string self = "the transition from '" + mode.name + "' to itself" + in_brackets(by.origin);
      return step + " is never taken: " +
             (by.timing ? "from " + automata::format_seconds(by.timing->upper) + " s on, " + self + " is overdue and"
                        : self + " has no time bounds and") +
             " happens in every step";
    }
    case Hindrance::Kind::missing:
    case Hindrance::Kind::disabled:
      break;
  }
  return step + " is not enabled, and no goal asks for a state that enables it";
}

}  // namespace rmpl::verifier
