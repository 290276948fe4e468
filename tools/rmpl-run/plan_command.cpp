// rmpl-run plan: the goal state and the nominal command sequence that leads there.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <string>

#include "automata/assignment_text.hpp"
#include "automata/place.hpp"
#include "automata/software/software_in.hpp"
#include "automata/step/plant_step.hpp"
#include "base/enumerated.hpp"
#include "base/error.hpp"
#include "runtime/executive/answer/plan_answer.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/reconfigure/plan.hpp"
#include "runtime/reasoning/reconfigure/plan_risks.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/policy_report.hpp"
#include "tools/rmpl-run/strategy_report.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

using runtime::JsonLine;
using runtime::Plan;
using runtime::PlanRisk;
using runtime::TransitionOf;

enum class PlanFormat { text, json, dot };

struct PlanOptions {
  std::string plant;
  std::string main;  ///< the definition that a model program starts with; empty: the one that no other calls
  std::string from;
  std::string goal;
  bool policy = false;
  bool strategy = false;
  automata::Ticks cycle;  ///< of the executive; 0: dense time
  PlanFormat format = PlanFormat::text;
  bool one_step = false;
  std::string component;
};

constexpr const char* plan_footer =
    R"(The commands are those that lead to the goal state if nothing fails, a line for each cycle: what the goal
needs, and what is worth more by reward. A wait is for a transition that needs no command. Components that
--from does not name are in their most likely initial mode.

A policy says for each current and target mode of a component what to achieve next: modes of others and a
command; 'idle' is to wait, 'failure' that no nominal transitions lead there.

A strategy says for each state that the plant may come to what is sent there, so that the goal is reached on
every run (rank sure), on every run on which chance gives each outcome its turn (fair), or on some run (hoped).

exit code: 0 there is a plan, or nothing to do; 1 there is no plan; 2 an input is wrong; 3 a strategy was asked
for, and the game has too many states

examples:
  rmpl-run plan propulsion.tcca --from 'engine = off, pde = off' --goal 'engine = firing'
  rmpl-run plan lander.tcca --from 'lander = unsuccessful-attempt' --goal 'lander = separated' --format json
  rmpl-run plan propulsion.tcca --policy --component engine)";

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
std::string text_of(const automata::Plant& plant, const Plan& plan, const std::vector<PlanRisk>& risks) {
  const std::string but =
      plan.bounds_counted ? ": the plan relies on this not happening" : ": the plan does not compare durations";
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
            (leaving.timing ? but : ": the awaited transition must occur in the same step") + "\n";
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
            "; while a program asserts it, it is commanded again\n";
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
  if (!plan.proved_best) text += "not proved optimal: the game is too large to search all commands\n";
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

ExitStatus print_policies(const PlanOptions& options, const Common& common, const automata::Plant& plant) {
  const auto components = components_named(plant, options.component);
  const runtime::NominalGraph graph(plant);
  if (common.format == Format::json) {
    JsonLine json;
    write_policies(json, plant, graph, components);
    print_json(std::string(json.text()) + "\n");
  } else {
    print(policy_text(plant, graph, components));
  }
  return ExitStatus::done;
}

ExitStatus print_strategy(const PlanOptions& options, automata::PlantStep& step, const automata::Modes& modes,
                          const automata::Formula& goal) {
  const automata::Plant& plant = step.plant();
  const runtime::NominalGraph graph(plant);
  runtime::Strategist strategist(step, graph, goal, options.cycle);
  const auto strategy = runtime::strategy_from(strategist, modes);
  if (!strategy) {
    throw base::LimitError(
        "plan: the game has too many states for an optimal strategy; `plan` without --strategy finds a plan step by "
        "step");
  }
  switch (options.format) {
    case PlanFormat::text:
      print(strategy_text(plant, *strategy));
      break;
    case PlanFormat::dot:
      print(strategy_dot(plant, *strategy));
      break;
    case PlanFormat::json: {
      JsonLine json;
      write_strategy(json, plant, *strategy);
      print_json(std::string(json.text()) + "\n");
      break;
    }
  }
  return strategy->rank == runtime::Rank::none ? ExitStatus::violated : ExitStatus::done;
}

ExitStatus run(const PlanOptions& options, Common common) {
  if (options.format == PlanFormat::json) common.format = Format::json;
  const compiler::Compilation compilation =
      load({options.plant}, common, {.main = options.main, .model_is_plant = true});
  const automata::Plant& plant = only_plant(compilation.document(), options.plant);
  if (options.policy) return print_policies(options, common, plant);
  if (options.goal.empty()) throw base::InputError("plan: expected --goal, or --policy");
  const automata::Component* const software = automata::software_in(plant);
  if (software != nullptr && options.cycle <= automata::Ticks{}) {
    throw base::InputError("plan: '" + software->name + "' is software, which takes a step a cycle; give --cycle T");
  }
  if (options.format == PlanFormat::dot && !options.strategy)
    throw base::InputError("plan: --format dot draws a strategy; expected --strategy with it");
  const auto given = assignments_option(options.from, plant, "--from", common);
  const automata::Formula goal = goal_option(options.goal, plant, "--goal", common);

  automata::PlantStep step(plant);
  const automata::Modes modes = runtime::modes_from(plant, given);
  runtime::expect_possible(step, modes);
  if (options.strategy) return print_strategy(options, step, modes, goal);
  const runtime::PlanAnswer answer = runtime::answer_plan(step, modes, goal, options.one_step, options.cycle);
  const Plan& plan = answer.plan;
  if (common.format == Format::json) {
    JsonLine json;
    write(json, plant, answer);
    print_json(std::string(json.text()) + "\n");
  } else {
    print(text_of(plant, plan) + text_of(plant, plan, answer.risks) + text_of(plant, answer.lost));
  }
  return plan.outcome == Plan::Outcome::no_plan ? ExitStatus::violated : ExitStatus::done;
}

}  // namespace

void add_plan(Program& program) {
  Command command = program.add_command("plan", "plan the commands that lead from a state to a goal");
  const auto options = std::make_shared<PlanOptions>();
  add_plant(command, options->plant, options->main);
  command.add_option("--from", options->from, "the modes to start from").option_text("'x = m, ...'");
  const Option goal =
      command.add_option("--goal", options->goal, "a constraint over modes and attributes").option_text("'constraint'");
  add_choice<bool>(command, "--reconfigurer", options->one_step, {{"planner", false}, {"one-step", true}},
                   "plan a sequence of commands, or find one sufficient control action (default: planner)");
  const Option policy =
      command.add_flag("--policy", options->policy, "print the policy of each component instead of a plan")
          .excludes(goal);
  command.add_option("--component", options->component, "with --policy: of this component only")
      .option_text("NAME")
      .needs(policy);
  command
      .add_flag("--strategy", options->strategy,
                "print the whole strategy: the command in each state that it may reach")
      .excludes(policy);
  add_read(command, "--cycle", options->cycle, positive_duration,
           "cycle of the executive that runs the plan (default: dense time, in which commands take no time)")
      .option_text("TIME");
  add_choice<PlanFormat>(command, "--format", options->format,
                         {{"text", PlanFormat::text}, {"json", PlanFormat::json}, {"dot", PlanFormat::dot}},
                         "text for people (the default), json for programs, dot for a picture of the strategy");
  command.footer(plan_footer);
  program.add({command, [options, &common = program.common()] { return run(*options, common); }});
}

}  // namespace rmpl::tools
