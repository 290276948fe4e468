// Reasons in words.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/reason.hpp"

#include "automata/place.hpp"

namespace rmpl::runtime {

using automata::Plant;

namespace {

const automata::Transition& transition(const Plant& plant, const TransitionOf& step) {
  return plant[step.component].transitions[step.transition.index()];
}

std::string mode(const Plant& plant, automata::ComponentId component, automata::ModeId m) {
  return "'" + plant[component].modes[m.index()].name + "'";
}

/// Where a component stays that takes a step which cannot be undone: behind modes that it only passes through, as time
/// alone leads on from them, to one other mode. What seems to lead back never does.
automata::ModeId lasting(const automata::Component& component, const automata::Transition& step) {
  automata::ModeId m = step.to;
  for (std::size_t passed = 0; passed < component.modes.size(); ++passed) {
    const automata::Transition* only = nullptr;
    for (const automata::Transition& t : component.transitions) {
      if (t.from != m || t.to == m || component.is_fault(t)) continue;
      if (only != nullptr || !t.timing) return m;
      only = &t;
    }
    if (only == nullptr) return m;
    if (only->to == step.from) return step.to;
    m = only->to;
  }
  return m;
}

std::string purpose(const Reason& reason, const Plant& plant, const automata::Formula& goal) {
  switch (reason.purpose) {
    case Reason::Purpose::none:
      return "";
    case Reason::Purpose::reward:
      return "for reward";
    case Reason::Purpose::model:
      return "all controls idle would contradict the model";
    case Reason::Purpose::goal:
      break;
  }
  const auto conjuncts = conjuncts_of(goal);
  const bool known = reason.conjunct && *reason.conjunct < conjuncts.size();
  return "for " + to_text(known ? conjuncts[*reason.conjunct] : goal, plant.variables);
}

}  // namespace

automata::Origin origin_of(const Plant& plant, const Reason& reason) {
  if (reason.step) return transition(plant, *reason.step).origin;
  if (reason.component && reason.aim) return plant[*reason.component].modes[reason.aim->index()].origin;
  return {};
}

std::string to_text(const Reason& reason, const Plant& plant, const automata::Formula& goal) {
  std::string text = purpose(reason, plant, goal);
  const char* const unproved = reason.proved_best ? "" : "; not proved optimal";
  if (text.empty() || (!reason.step && !reason.component)) return text + unproved;
  if (reason.component && reason.aim &&
      (!reason.step || reason.step->component != *reason.component ||
       transition(plant, *reason.step).to != *reason.aim)) {
    text += ", '" + plant[*reason.component].name + "' to " + mode(plant, *reason.component, *reason.aim);
  }
  if (reason.step) {
    const auto& t = transition(plant, *reason.step);
    text += ": '" + plant[reason.step->component].name + "' from " + mode(plant, reason.step->component, t.from) +
            " to " + mode(plant, reason.step->component, t.to) + in_parentheses(t.origin);
  }
  return text + unproved;
}

std::string remedy(const Reason& reason, const Plant& plant) {
  const auto named = [&] {
    const auto component = reason.step ? reason.step->component : *reason.component;
    return plant.variables.name(plant[component].mode) + " = ";
  };
  switch (reason.obstacle) {
    case Reason::Obstacle::none:
    case Reason::Obstacle::not_found:
    case Reason::Obstacle::excluded:
      return "";
    case Reason::Obstacle::missing:
      if (!reason.component || !reason.aim) return "";
      if (plant[*reason.component].modes[reason.aim->index()].fault) {
        return mode(plant, *reason.component, *reason.aim) + " is a fault mode, and no command leads into a fault mode";
      }
      return "a nominal transition of '" + plant[*reason.component].name + "' to " +
             mode(plant, *reason.component, *reason.aim) + " would permit a plan";
    case Reason::Obstacle::forbidden:
      if (!reason.step) return "";
      return "a goal that asks for " + named() +
             plant[reason.step->component]
                 .modes[lasting(plant[reason.step->component], transition(plant, *reason.step)).index()]
                 .name +
             " or transitions back in the model would permit a plan; so would a progress component, if '" +
             plant[reason.step->component].name + "' is meant to go only forward";
    case Reason::Obstacle::unsupported:
      return "a control or a mode that makes its guard true would permit a plan";
    case Reason::Obstacle::side_effect:
      return "a command without this side effect would permit a plan";
  }
  return "";
}

}  // namespace rmpl::runtime
