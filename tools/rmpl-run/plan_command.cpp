// rmpl-run plan: the goal state and the nominal command sequence that leads there.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <string>

#include "automata/assignment_text.hpp"
#include "automata/place.hpp"
#include "automata/step/plant_step.hpp"
#include "base/enumerated.hpp"
#include "base/error.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/reconfigure/one_step.hpp"
#include "runtime/reasoning/reconfigure/plan.hpp"
#include "runtime/reasoning/reconfigure/plan_risks.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/policy_report.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

using runtime::JsonLine;
using runtime::Plan;
using runtime::PlanRisk;
using runtime::TransitionOf;

struct Options {
  std::string plant;
  std::string from;
  std::string goal;
  bool policy = false;
  bool one_step = false;
  std::string component;
};

constexpr const char* footer =
    R"(The commands are those that lead to the goal state if nothing fails, one a cycle: first what the goal
needs, then what is worth more by reward. A wait is for a transition that needs no command. Components that
--from does not name are in their most likely initial mode.

A policy says for each current and target mode of a component what to achieve next: modes of others and a
command; 'idle' is to wait, 'failure' that no nominal transitions lead there.

exit code: 0 there is a plan, or nothing to do; 1 there is no plan; 2 an input is wrong

examples:
  rmpl-run plan propulsion.tcca --from 'engine = off, pde = off' --goal 'engine = firing'
  rmpl-run plan lander.tcca --from 'lander = unsuccessful-attempt' --goal 'lander = separated' --format json
  rmpl-run plan propulsion.tcca --policy --component engine)";

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

/// The most likely initial modes, ties to the first, with those that are given.
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

void write_json(JsonLine& json, const automata::Plant& plant, const Plan& plan, const std::vector<PlanRisk>& risks,
                const std::vector<TransitionOf>& lost) {
  json.open('{');
  json.key("goal_state").modes(plan.goal_state.value_or(automata::Modes{}), plant);
  json.key("commands").open('[');
  for (const automata::ControlAction& action : plan.commands) {
    json.assignments(automata::commanded(plant, action), plant.variables);
  }
  json.close(']').key("outcome").string(name_of(plan.outcome));
  if (!risks.empty()) write_risks(json, plant, risks);
  if (!lost.empty()) write_lost(json, plant, lost);
  if (plan.component) json.key("component").string(plant[*plan.component].name);
  if (!plan.reason.empty()) json.key("reason").string(plan.reason);
  if (const std::string would = runtime::remedy(plan.why, plant); !would.empty()) json.key("remedy").string(would);
  json.close('}');
}

/// Where the model says so, and what would permit it; a line where there is something to say.
std::string hint(const automata::Plant& plant, const runtime::Reason& why) {
  const automata::Origin origin = runtime::origin_of(plant, why);
  const std::string would = runtime::remedy(why, plant);
  if (would.empty()) return "";
  return "  " + (origin.line == 0 ? "" : short_place(origin) + ": ") + would + "\n";
}

/// `step 3 waits`, `steps 3, 5 and 6 wait`.
std::string waiting(const std::vector<std::string>& steps) {
  return steps.size() == 1 ? "step " + steps.front() + " waits" : "steps " + base::enumerated(steps) + " wait";
}

/// A line for each transition, with all the waits in which it may come.
std::string text_of(const automata::Plant& plant, const std::vector<PlanRisk>& risks) {
  std::vector<std::pair<TransitionOf, std::vector<std::string>>> lines;
  for (const PlanRisk& risk : risks) {
    const auto known = std::find_if(lines.begin(), lines.end(), [&](const auto& l) { return l.first == risk.leaving; });
    auto& line = known != lines.end() ? *known : lines.emplace_back(risk.leaving, std::vector<std::string>{});
    line.second.push_back(std::to_string(risk.wait + 1));
  }
  std::string text;
  for (const auto& [move, waits] : lines) {
    const automata::Component& component = plant[move.component];
    const automata::Transition& leaving = component.transitions[move.transition.index()];
    text += waiting(waits) + ", and meanwhile '" + component.name + "' " + (leaving.timing ? "may go" : "goes") +
            " from '" + component.modes[leaving.from.index()].name + "' to '" +
            component.modes[leaving.to.index()].name + "' by itself" +
            (leaving.origin.line == 0 ? "" : " (" + short_place(leaving.origin) + ")") +
            (leaving.timing ? ": how long each takes is not compared\n"
                            : ": what is waited for would have to come in that very step\n");
  }
  return text;
}

std::string text_of(const automata::Plant& plant, const std::vector<TransitionOf>& lost) {
  std::string text;
  for (const TransitionOf& leaving : lost) {
    const automata::Component& component = plant[leaving.component];
    const automata::Transition& t = component.transitions[leaving.transition.index()];
    text += "the goal does not last: '" + component.name + "' goes from '" + component.modes[t.from.index()].name +
            "' to '" + component.modes[t.to.index()].name + "' by itself in the next step" +
            (t.origin.line == 0 ? "" : " (" + short_place(t.origin) + ")") +
            "; where it is asked for on and on, it is commanded on and on\n";
  }
  return text;
}

std::string text_of(const automata::Plant& plant, const Plan& plan) {
  std::string text;
  switch (plan.outcome) {
    case Plan::Outcome::no_plan:
      text = "no plan";
      if (plan.component) text += " for " + plant[*plan.component].name;
      if (!plan.reason.empty()) text += ": " + plan.reason;
      return text + "\n" + hint(plant, plan.why);
    case Plan::Outcome::nothing_to_do:
      text = "nothing to do: the goal is achieved\n";
      break;
    case Plan::Outcome::plan:
      for (std::size_t i = 0; i < plan.commands.size(); ++i) {
        const std::string command = to_text(plant.variables, automata::commanded(plant, plan.commands[i]));
        text += std::to_string(i + 1) + ". " + (command.empty() ? "wait" : command) + "\n";
      }
      break;
  }
  if (plan.goal_state) {
    text += "goal state: " + to_text(plant.variables, automata::assignments_of(plant, *plan.goal_state)) + "\n";
  }
  return text;
}

std::vector<automata::ComponentId> components_named(const automata::Plant& plant, const std::string& name) {
  std::vector<automata::ComponentId> result;
  std::vector<std::string_view> names;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    names.emplace_back(plant.components[c].name);
    if (name.empty() || plant.components[c].name == name) result.emplace_back(c);
  }
  if (result.empty()) {
    throw base::InputError("--component: plant '" + plant.name + "' has no component '" + name + "'" +
                           suggestion_or_list(name, names));
  }
  return result;
}

ExitStatus print_policies(const Options& options, const Common& common, const automata::Plant& plant) {
  const auto components = components_named(plant, options.component);
  const runtime::NominalGraph graph(plant);
  if (common.format == Format::json) {
    JsonLine json;
    write_policies(json, plant, graph, components);
    print(std::string(json.text()) + "\n");
  } else {
    print(policy_text(plant, graph, components));
  }
  return ExitStatus::done;
}

ExitStatus run(const Options& options, const Common& common) {
  const compiler::Compilation compilation = load({options.plant}, common);
  const automata::Plant& plant = only_plant(compilation.document(), options.plant);
  if (options.policy) return print_policies(options, common, plant);
  if (options.goal.empty()) throw base::InputError("plan: expected --goal, or --policy");
  const auto given = assignments_option(options.from, plant, "--from", common);
  const automata::Formula goal = formula_option(options.goal, plant, "--goal", common);

  automata::PlantStep step(plant);
  const automata::Modes modes = modes_from(plant, given);
  if (!step.possible(modes)) {
    throw base::InputError("--from: the plant cannot be in " +
                           to_text(plant.variables, automata::assignments_of(plant, modes)) +
                           ": the model forbids these modes together");
  }
  const auto reconfigurer =
      options.one_step ? runtime::make_one_step_reconfigurer(step) : runtime::make_reconfigurer(step);
  const Plan plan = options.one_step ? runtime::make_one_step_plan(*reconfigurer, modes, goal)
                                     : runtime::make_plan(plant, *reconfigurer, modes, goal);
  const std::vector<PlanRisk> risks = runtime::risks_of(plan, step, goal);
  const std::vector<TransitionOf> lost = runtime::lost_in_the_end(plan, step, goal);
  if (common.format == Format::json) {
    JsonLine json;
    write_json(json, plant, plan, risks, lost);
    print(std::string(json.text()) + "\n");
  } else {
    print(text_of(plant, plan) + text_of(plant, risks) + text_of(plant, lost));
  }
  return plan.outcome == Plan::Outcome::no_plan ? ExitStatus::violated : ExitStatus::done;
}

}  // namespace

void add_plan(Program& program) {
  CLI::App* command = program.app().add_subcommand("plan", "find the commands that lead from a state to a goal");
  const auto options = std::make_shared<Options>();
  command->add_option("PLANT", options->plant, "a .tcca model, or a compiled .json")->required();
  command->add_option("--from", options->from, "the modes to start from")->option_text("'x = m, ...'");
  auto* const goal = command->add_option("--goal", options->goal, "a constraint over modes and attributes")
                         ->option_text("'constraint'");
  add_choice<bool>(*command, "--reconfigurer", options->one_step, {{"planner", false}, {"one-step", true}},
                   "a sequence of commands, or one control action that is enough (default: planner)");
  auto* const policy =
      command->add_flag("--policy", options->policy, "print the policy of each component instead of a plan")
          ->excludes(goal);
  command->add_option("--component", options->component, "with --policy: of this component only")
      ->option_text("NAME")
      ->needs(policy);
  add_format(*command, program.common());
  command->footer(footer);
  program.add({command, [options, &common = program.common()] { return run(*options, common); }});
}

}  // namespace rmpl::tools
