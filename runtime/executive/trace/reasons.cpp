// The keys of a reason.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/reasons.hpp"

#include <string_view>

#include "runtime/executive/trace/place.hpp"
#include "runtime/reasoning/reconfigure/outcome.hpp"

namespace rmpl::runtime {
namespace {

std::string_view name_of(Reason::Purpose purpose) {
  switch (purpose) {
    case Reason::Purpose::none:
      return "none";
    case Reason::Purpose::goal:
      return "goal";
    case Reason::Purpose::reward:
      return "reward";
    case Reason::Purpose::model:
      return "model";
  }
  return {};
}

std::string_view name_of(Reason::Obstacle obstacle) {
  switch (obstacle) {
    case Reason::Obstacle::none:
      return "none";
    case Reason::Obstacle::missing:
      return "missing";
    case Reason::Obstacle::forbidden:
      return "forbidden";
    case Reason::Obstacle::unsupported:
      return "unsupported";
    case Reason::Obstacle::side_effect:
      return "side-effect";
    case Reason::Obstacle::excluded:
      return "excluded";
    case Reason::Obstacle::not_found:
      return "not-found";
  }
  return {};
}

}  // namespace

Reason::Purpose purpose_named(std::string_view name) {
  for (const auto one : {Reason::Purpose::goal, Reason::Purpose::reward, Reason::Purpose::model}) {
    if (name_of(one) == name) return one;
  }
  return Reason::Purpose::none;
}

Reason::Obstacle obstacle_named(std::string_view name) {
  using Obstacle = Reason::Obstacle;
  for (const auto one : {Obstacle::missing, Obstacle::forbidden, Obstacle::unsupported, Obstacle::side_effect,
                         Obstacle::excluded, Obstacle::not_found}) {
    if (name_of(one) == name) return one;
  }
  return Obstacle::none;
}

void write_reason(JsonLine& line, Reconfiguration::Outcome outcome, const Reason& why, const automata::Goals& goals,
                  const automata::Plant& plant) {
  if (outcome == Reconfiguration::Outcome::nothing_to_do) return;
  line.key("reason").open('{').key("outcome").string(name_of(outcome));
  if (!why.proved_best) line.key("solved").boolean(false);
  if (why.purpose != Reason::Purpose::none) line.key("purpose").string(name_of(why.purpose));
  if (why.conjunct) {
    const std::size_t conjunct = *why.conjunct;
    const std::size_t modes = goals.goal.size();
    if (conjunct < modes) line.key("goal").assignments({&goals.goal[conjunct], 1}, plant.variables);
    if (conjunct >= modes && conjunct - modes < goals.constraints.size())
      line.key("goal_constraint").string(to_text(goals.constraints[conjunct - modes].formula, plant.variables));
  }
  if (why.component) {
    line.key("component").string(plant[*why.component].name);
    if (why.aim) line.key("aim").string(plant[*why.component].modes[why.aim->index()].name);
  }
  if (why.step) {
    const automata::Component& component = plant[why.step->component];
    const automata::Transition& transition = component.transitions[why.step->transition.index()];
    line.key("transition").open('{').key("component").string(component.name);
    line.key("from").string(component.modes[transition.from.index()].name);
    line.key("to").string(component.modes[transition.to.index()].name);
    write_place(line, transition.origin);
    line.close('}');
  }
  if (why.obstacle != Reason::Obstacle::none) {
    line.key("obstacle").string(name_of(why.obstacle));
    if (const std::string way_out = remedy(why, plant); !way_out.empty()) line.key("remedy").string(way_out);
  }
  line.close('}');
}

}  // namespace rmpl::runtime
