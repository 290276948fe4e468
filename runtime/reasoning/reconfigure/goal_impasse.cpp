// The goal interpreter: why no goal state is left, and what bars the way to one.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "automata/assignment_text.hpp"
#include "runtime/reasoning/reconfigure/goal_interpreter.hpp"

namespace rmpl::runtime {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::Theory;
using automata::ValueId;

namespace {

/// A nominal transition out of a mode to one that is asked for, whose guard the store of that mode refutes: where that
/// is why a component cannot go on, the mode or the guard is wrong.
std::string dead_guard(automata::PlantStep& step, ComponentId component, ModeId mode, const std::vector<bool>& asked) {
  const automata::Component& automaton = step.plant()[component];
  const automata::Assignment in{automaton.mode, automata::ValueId(mode.index())};
  for (const automata::Transition& t : automaton.transitions) {
    if (t.from != mode || !asked[t.to.index()] || automaton.is_fault(t)) continue;
    if (step.theory().allows(std::span(&in, 1), step.theory().encode(t.guard))) continue;
    const automata::Mode& from = automaton.modes[mode.index()];
    return ": the constraint of '" + from.name + "'" + in_brackets(from.origin) +
           " contradicts the guard of its transition to '" + automaton.modes[t.to.index()].name + "'" +
           in_brackets(t.origin);
  }
  return "";
}

}  // namespace

/// Goes upstream as long as it is another component that bars the way: the last one is to blame.
Impasse GoalInterpreter::out_of_reach(const Modes& modes, const ReachableModes& reach, ComponentId component,
                                      std::vector<bool> asked) {
  const Plant& plant = step_.plant();
  const auto name = [&](ComponentId c, ModeId m) { return "'" + plant[c].modes[m.index()].name + "'"; };
  std::string purpose;
  std::vector<bool> visited(modes.size());
  for (;;) {
    std::string wanted;
    std::optional<ModeId> aim;
    for (std::size_t m = 0; m < asked.size(); ++m) {
      if (!asked[m]) continue;
      wanted += (wanted.empty() ? "" : " or ") + name(component, ModeId(m));
      if (!aim) aim = ModeId(m);
    }
    Reason why;
    why.purpose = Reason::Purpose::goal;
    why.component = component;
    why.aim = aim;
    if (wanted.empty()) {
      why.obstacle = Reason::Obstacle::excluded;
      return {component, "the goal permits no mode of '" + plant[component].name + "'", why};
    }
    const ReachableModes::Barrier barrier = reach.barrier(component, asked);
    const auto* const t = barrier.transition;
    if (t != nullptr && barrier.requirement == nullptr) {
      why.obstacle = Reason::Obstacle::forbidden;
      why.step = TransitionOf{component, t->id};
      return {component,
              "the goal needs the irreversible step of '" + plant[component].name + "' from " +
                  name(component, t->from) + " to " + name(component, t->to) + purpose +
                  ", but does not name the mode to which this step leads",
              why};
    }
    const auto upstream = t == nullptr ? std::nullopt : graph_.component_of(*barrier.requirement);
    if (!upstream || visited[component.index()]) {
      why.obstacle = t == nullptr ? Reason::Obstacle::missing : Reason::Obstacle::unsupported;
      if (t != nullptr) why.step = TransitionOf{component, t->id};
      std::string reason = "no permitted nominal transitions lead '";
      reason.append(plant[component].name).append("' from ").append(name(component, modes[component.index()]));
      reason.append(" to ").append(wanted).append(purpose);
      reason += dead_guard(step_, component, modes[component.index()], asked);
      return {component, std::move(reason), why};
    }
    visited[component.index()] = true;
    std::string needs = ", as '";
    needs.append(plant[component].name).append("' needs to go from ").append(name(component, t->from));
    needs.append(" to ").append(name(component, t->to)).append(purpose);
    purpose = std::move(needs);
    component = *upstream;
    asked.assign(plant[component].modes.size(), false);
    for (const ValueId v : barrier.requirement->values) asked[v.index()] = true;
  }
}

namespace {

Reason excluded_reason() {
  Reason why;
  why.purpose = Reason::Purpose::goal;
  why.obstacle = Reason::Obstacle::excluded;
  return why;
}

}  // namespace

/// Why a component does not come to the mode, or one of those, that would by itself imply the goal; nothing where there
/// is no such component.
std::optional<Impasse> GoalInterpreter::barred_mode(const Modes& modes, const Goal& goal, const ReachableModes& reach) {
  if (!goal.rest()) return std::nullopt;
  Theory& theory = step_.theory();
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const Component& component = step_.plant().components[c];
    std::vector<bool> asked(component.modes.size(), false);
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      if (component.modes[m].fault || reach.contains(ComponentId(c), ModeId(m))) continue;
      const std::array in{Assignment{component.mode, ValueId(m)}};
      asked[m] = theory.allows(in, goal.rest()->holds) && !theory.allows(in, goal.rest()->fails);
    }
    if (std::find(asked.begin(), asked.end(), true) == asked.end()) continue;
    Impasse barred = out_of_reach(modes, reach, ComponentId(c), std::move(asked));
    barred.reason = "no reachable state implies the goal: " + barred.reason;
    return barred;
  }
  return std::nullopt;
}

/// The most telling of: a component that cannot reach what the goal asks of it; modes that are the only ones left and
/// exclude each other or the goal.
Impasse GoalInterpreter::impasse(const Modes& modes, const Goal& goal, const ReachableModes& reach) {
  const Plant& plant = step_.plant();
  std::vector<Assignment> forced;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const Component& component = plant.components[c];
    std::vector<ModeId> left;
    std::vector<bool> asked(component.modes.size());
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      asked[m] = goal.permits(ComponentId(c), ModeId(m));
      if (asked[m] && reach.contains(ComponentId(c), ModeId(m))) left.emplace_back(m);
    }
    if (left.empty()) return out_of_reach(modes, reach, ComponentId(c), std::move(asked));
    if (left.size() == 1) forced.push_back({component.mode, ValueId(left.front().index())});
  }
  const auto& rest = goal.rest();
  Theory& theory = step_.theory();
  const bool excluded = rest ? !theory.allows(forced, rest->holds) : !theory.consistent(forced);
  if (!excluded) {
    if (auto barred = barred_mode(modes, goal, reach)) return *std::move(barred);
    return {std::nullopt, "no reachable state implies the goal", excluded_reason()};
  }

  if (theory.conflict().empty())
    return {std::nullopt, "no possible state of the plant implies the goal", excluded_reason()};

  // What would permit more is a step that must not be taken, where there is one.
  for (const Assignment& a : std::vector<Assignment>(theory.conflict())) {
    const ComponentId c = *plant.component_of(a.variable);
    std::vector<bool> others(plant[c].modes.size(), true);
    others[modes[c.index()].index()] = false;
    const ReachableModes::Barrier barrier = reach.barrier(c, others);
    if (barrier.transition == nullptr || barrier.requirement != nullptr) continue;
    Impasse forbidden = out_of_reach(modes, reach, c, std::move(others));
    forbidden.reason = "no reachable state implies the goal: " + forbidden.reason;
    return forbidden;
  }

  // The one to blame is a component in a fault mode, where there is one: the others do what they are asked.
  Impasse result{std::nullopt, {}, excluded_reason()};
  for (const Assignment& a : theory.conflict()) {
    const ComponentId c = *plant.component_of(a.variable);
    if (!result.component || (plant[c].modes[a.value.index()].fault &&
                              !plant[*result.component].modes[modes[result.component->index()].index()].fault)) {
      result.component = c;
    }
    result.reason += (result.reason.empty() ? "" : " & ") + to_text(plant.variables, a);
  }
  result.why.component = result.component;
  if (result.component) result.why.aim = modes[result.component->index()];
  result.reason = "no reachable state implies the goal: " + result.reason +
                  (rest ? (theory.conflict().size() == 1 ? " excludes it" : " exclude it")
                        : " exclude each other, and no other modes are reachable");
  return result;
}

}  // namespace rmpl::runtime
