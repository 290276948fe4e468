// Commands that lead in a circle.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/circle.hpp"

#include <algorithm>

#include "automata/place.hpp"
#include "base/check.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ModeId;
using automata::Modes;
using automata::Plant;

namespace {

TransitionOf transition_of(const Plant& plant, ComponentId component, ModeId from, ModeId to) {
  const auto& transitions = plant[component].transitions;
  const auto found = std::ranges::find_if(transitions, [&](const automata::Transition& t) {
    return t.from == from && t.to == to && !plant[component].is_fault(t);
  });
  CHECK(found != transitions.end() && "a nominal step takes nominal transitions");
  return {component, automata::TransitionId(static_cast<std::size_t>(found - transitions.begin()))};
}

std::string modes_of(const Plant& plant, const TransitionOf& step) {
  const automata::Component& component = plant[step.component];
  const automata::Transition& t = component.transitions[step.transition.index()];
  return "'" + component.modes[t.from.index()].name + "' to '" + component.modes[t.to.index()].name + "'" +
         in_parentheses(t.origin);
}

}  // namespace

Circle circle_in(const Plant& plant, std::span<const Modes> states) {
  const auto moved = std::ranges::mismatch(states[0], states[1]).in1;
  CHECK(moved != states[0].end() && "a step on a circle leads on");
  const auto c = static_cast<std::size_t>(moved - states[0].begin());
  std::size_t last = states.size() - 1;
  while (states[last - 1][c] == states[last][c]) --last;
  const ComponentId component(c);
  return {transition_of(plant, component, states[0][c], states[1][c]),
          transition_of(plant, component, states[last - 1][c], states[last][c])};
}

std::string to_text(const Circle& circle, const Plant& plant) {
  return "'" + plant[circle.there.component].name + "' from " + modes_of(plant, circle.there) + " is undone by " +
         modes_of(plant, circle.back);
}

}  // namespace rmpl::runtime
