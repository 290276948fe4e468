// One question to a reconfigurer, and its answer as JSON.
// SPDX-License-Identifier: MIT
#include "runtime/executive/answer/plan_answer.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "automata/assignment_text.hpp"
#include "base/error.hpp"
#include "runtime/reasoning/reconfigure/one_step.hpp"

namespace rmpl::runtime {
namespace {

std::string_view name_of(Plan::Outcome outcome) {
  switch (outcome) {
    case Plan::Outcome::plan:
      return "plan";
    case Plan::Outcome::no_plan:
      return "no-plan";
    case Plan::Outcome::nothing_to_do:
      return "nothing-to-do";
  }
  return {};
}

void write_lost(JsonLine& json, const automata::Plant& plant, const std::vector<TransitionOf>& lost) {
  json.key("lost").open('[');
  for (const TransitionOf& leaving : lost) {
    const automata::Component& component = plant[leaving.component];
    const automata::Transition& t = component.transitions[leaving.transition.index()];
    json.open('{').key("component").string(component.name);
    json.key("from").string(component.modes[t.from.index()].name);
    json.key("to").string(component.modes[t.to.index()].name).close('}');
  }
  json.close(']');
}

void write_risks(JsonLine& json, const automata::Plant& plant, const std::vector<PlanRisk>& risks) {
  json.key("risks").open('[');
  for (const PlanRisk& risk : risks) {
    const automata::Component& component = plant[risk.leaving.component];
    const automata::Transition& leaving = component.transitions[risk.leaving.transition.index()];
    json.open('{').key("wait").number(risk.wait + 1).key("component").string(component.name);
    json.key("from").string(component.modes[leaving.from.index()].name);
    json.key("to").string(component.modes[leaving.to.index()].name).close('}');
  }
  json.close(']');
}

}  // namespace

void write(JsonLine& json, const automata::Plant& plant, const PlanAnswer& answer) {
  const Plan& plan = answer.plan;
  json.open('{');
  json.key("goal_state").modes(plan.goal_state.value_or(automata::Modes{}), plant);
  json.key("commands").open('[');
  for (const automata::ControlAction& action : plan.commands) {
    json.assignments(automata::commanded(plant, action), plant.variables);
  }
  json.close(']').key("outcome").string(name_of(plan.outcome));
  if (!plan.proved_best) json.key("solved").boolean(false);
  if (!answer.risks.empty()) write_risks(json, plant, answer.risks);
  if (!answer.lost.empty()) write_lost(json, plant, answer.lost);
  if (plan.component) json.key("component").string(plant[*plan.component].name);
  if (!plan.reason.empty()) json.key("reason").string(plan.reason);
  if (const std::string would = remedy(plan.why, plant); !would.empty()) json.key("remedy").string(would);
  json.close('}');
}

automata::Modes modes_from(const automata::Plant& plant, const std::vector<automata::Assignment>& given) {
  automata::Modes modes;
  for (const automata::Component& component : plant.components) {
    const auto best = std::max_element(component.initial.begin(), component.initial.end());
    modes.emplace_back(static_cast<std::size_t>(best - component.initial.begin()));
  }
  for (const automata::Assignment& mode : given) {
    const auto component = plant.component_of(mode.variable);
    if (!component) {
      throw base::InputError("--from: '" + plant.variables.name(mode.variable) + "' is no component of plant '" +
                             plant.name + "'; expected modes of components");
    }
    modes[component->index()] = automata::ModeId(mode.value.index());
  }
  return modes;
}

void expect_possible(automata::PlantStep& step, const automata::Modes& modes) {
  if (step.possible(modes)) return;
  const automata::Plant& plant = step.plant();
  throw base::InputError("--from: the plant cannot be in " +
                         to_text(plant.variables, automata::assignments_of(plant, modes)) +
                         ": the model forbids these modes together");
}

PlanAnswer answer_plan(automata::PlantStep& step, const automata::Modes& modes, const automata::Formula& goal,
                       bool one_step, automata::Ticks cycle) {
  const automata::Plant& plant = step.plant();
  const auto reconfigurer = one_step ? make_one_step_reconfigurer(step) : make_reconfigurer(step, nullptr, cycle);
  PlanAnswer answer;
  answer.plan =
      one_step ? make_one_step_plan(*reconfigurer, modes, goal) : make_plan(plant, *reconfigurer, modes, goal);
  if (!answer.plan.sure || !answer.plan.bounds_counted) answer.risks = risks_of(answer.plan, step, goal);
  answer.lost = lost_in_the_end(answer.plan, step, goal);
  return answer;
}

}  // namespace rmpl::runtime
