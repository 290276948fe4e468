// Model programs that are flown: plans and simulated plants against enumeration.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "automata/facade.hpp"
#include "automata/step/marked_plant.hpp"
#include "base/error.hpp"
#include "runtime/executive/scenario/engines.hpp"
#include "runtime/reasoning/reconfigure/marked_reconfigurer.hpp"
#include "runtime/reasoning/reconfigure/marking_planner.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate_model_program.hpp"
#include "tests/reference/marking_plans.hpp"

namespace rmpl::property {
namespace {

using automata::Assignment;
using automata::Command;
using automata::Marking;
using automata::ModelProgram;
using automata::Ticks;
using automata::ValueId;
using automata::VariableId;
using reference::MarkedSet;
using runtime::MarkingMove;

/// What can be flown: every control can be left alone.
ModelProgram flyable(std::size_t most_primitive) {
  ModelProgram program = (*model_programs(most_primitive)).program;
  for (automata::CommandedVariable& control : program.controls) control.idle = control.idle.value_or(ValueId(0));
  return program;
}

Marking primitive(const ModelProgram& program, const MarkedSet& marking) {
  Marking result(marking.begin(), marking.end());
  std::erase_if(result, [&](automata::LocationId l) { return program.locations[l.index()].composite; });
  return result;
}

reference::FreeCommand free_command(const ModelProgram& program, const Command& command) {
  reference::FreeCommand result;
  for (std::size_t c = 0; c < command.size(); ++c) {
    result.values.push_back({program.controls[c].variable, *command[c]});
    result.busy += command[c] != program.controls[c].idle ? 1 : 0;
  }
  return result;
}

std::vector<reference::FreeCommand> free_commands(const ModelProgram& program) {
  std::vector<Command> commands{{}};
  for (const automata::CommandedVariable& control : program.controls) {
    std::vector<Command> longer;
    for (const Command& command : commands) {
      for (std::size_t v = 0; v < program.variables[control.variable].values.size(); ++v) {
        longer.push_back(command);
        longer.back().emplace_back(ValueId(v));
      }
    }
    commands = std::move(longer);
  }
  std::vector<reference::FreeCommand> result;
  for (const Command& command : commands) result.push_back(free_command(program, command));
  return result;
}

/// A marking that some run comes to.
MarkedSet some_marking(const reference::ModelProgramStep& slow, const std::vector<reference::FreeCommand>& free) {
  const auto one_of = [](const reference::MarkingBelief& belief) {
    std::vector<MarkedSet> markings;
    for (const auto& entry : belief) markings.push_back(entry.first);
    RC_PRE(!markings.empty());
    return pick(markings);
  };
  MarkedSet marking = one_of(slow.initial());
  for (std::size_t steps = up_to(0, 3); steps > 0; --steps) {
    const auto next = slow.next(marking, pick(free).values);
    if (!next.empty()) marking = one_of(next);
  }
  return marking;
}

/// With the composites that hold something of it.
MarkedSet whole(const ModelProgram& program, const Marking& marking) {
  MarkedSet result;
  for (const automata::LocationId l : marking) {
    for (auto at = std::optional(l); at; at = program.locations[at->index()].parent) result.insert(*at);
  }
  return result;
}

/// Most often of what some marking entails.
std::vector<Assignment> some_goal(const ModelProgram& program, const reference::ModelProgramStep& slow,
                                  const MarkedSet& reached) {
  std::vector<Assignment> goal;
  for (const auto& [variable, value] : slow.values(reached)) {
    if (chance(70)) goal.push_back({variable, value});
  }
  if (!goal.empty() && chance(90)) return goal;
  for (std::size_t n = up_to(1, 2); n > 0; --n) {
    const VariableId variable(up_to(0, program.variables.size() - 1));
    goal.push_back({variable, ValueId(up_to(0, program.variables[variable].values.size() - 1))});
  }
  return goal;
}

/// A marking and a goal, and the cheapest way there, of no more than `most_steps`.
struct Question {
  explicit Question(std::size_t most_steps)
      : program(flyable(4)),
        slow(program),
        free(free_commands(program)),
        from(some_marking(slow, free)),
        goal(some_goal(program, slow, some_marking(slow, free))),
        cost(cheapest(slow, free, from, goal, most_steps)) {
    RC_TAG(cost ? "a way of " + std::to_string(cost->steps) : std::string("none"));
  }

  /// Whether a likely outcome of the command is one from which the rest of the way is as `rest` says.
  template <class Rest>
  bool leads_on(const reference::FreeCommand& command, const Rest& rest) const {
    bool result = false;
    slow.for_each_next(from, command.values, [&](const MarkedSet& target, double, unsigned improbable) {
      if (improbable > 0) return;
      const auto left = cheapest(slow, free, target, goal, cost->steps - 1);
      result = result || (left && rest(*left));
    });
    return result;
  }

  const ModelProgram program;
  const reference::ModelProgramStep slow;
  const std::vector<reference::FreeCommand> free;
  const MarkedSet from;
  const std::vector<Assignment> goal;
  const std::optional<reference::PlanCost> cost;
};

RC_GTEST_PROP(FlownModels, PlansAreTheCheapest, ()) {
  const Question asked(5);
  const auto& cost = asked.cost;
  runtime::MarkingPlanner planner(asked.program);
  const MarkingMove move = planner.next(primitive(asked.program, asked.from), asked.goal);
  RC_ASSERT(move.kind != MarkingMove::Kind::given_up);
  if (!cost) {
    if (move.kind == MarkingMove::Kind::nowhere || move.kind == MarkingMove::Kind::failure) return;
    RC_ASSERT(move.kind == MarkingMove::Kind::step);  // a longer way
    return;
  }
  RC_ASSERT((move.kind == MarkingMove::Kind::done) == (cost->steps == 0));
  if (cost->steps == 0) return;
  RC_ASSERT(move.kind == MarkingMove::Kind::step);
  const reference::FreeCommand command = free_command(asked.program, move.command);
  RC_ASSERT(command.busy <= cost->busy);
  RC_ASSERT(asked.leads_on(command, [&](const reference::PlanCost& left) {
    return left == reference::PlanCost{cost->steps - 1, cost->busy - command.busy};
  }));
}

/// Groups of threads that are planned for apart, and together where they must be: what the whole of them takes.
RC_GTEST_PROP(FlownModels, PlansOfGroupsAreTheShortestOfAll, ()) {
  const Question asked(4);
  const auto& cost = asked.cost;
  const automata::MarkedPlant plant(asked.program);
  for (const Assignment& wanted : asked.goal) RC_PRE(plant.plant().component_of(wanted.variable).has_value());
  std::vector<Assignment> values;
  for (const auto& [variable, value] : asked.slow.values(asked.from)) values.push_back({variable, value});
  const auto reconfigurer = runtime::make_marked_reconfigurer(asked.program, plant);
  const auto answer = reconfigurer->next(plant.modes(primitive(asked.program, asked.from), values),
                                         automata::conjunction_of(asked.goal));
  using Outcome = runtime::Reconfiguration::Outcome;
  if (answer.outcome == Outcome::no_plan) RC_ASSERT(!cost);
  if (!cost) return;
  const bool at_rest =
      answer.outcome == Outcome::nothing_to_do || answer.why.purpose == runtime::Reason::Purpose::model;
  RC_ASSERT(at_rest == (cost->steps == 0));
  if (cost->steps == 0) return;
  const reference::FreeCommand command = free_command(asked.program, automata::command_of(answer.action));
  RC_ASSERT(asked.leads_on(command, [&](const reference::PlanCost& left) { return left.steps == cost->steps - 1; }));
}

RC_GTEST_PROP(FlownModels, ThePlantFollowsTheModel, ()) {
  const ModelProgram program = flyable(4);
  const reference::ModelProgramStep slow(program);
  RC_PRE(!slow.initial().empty());
  const automata::MarkedPlant seen(program);
  const automata::Plant& plant = seen.plant();
  automata::Scenario scenario;
  const std::size_t cycles = up_to(1, 4);
  const std::size_t shown = automata::facade_of(program).components.size();
  for (std::size_t n = shown > 0 ? up_to(0, 2) : 0; n > 0; --n) {
    const automata::ComponentId component(up_to(0, shown - 1));
    const std::size_t values = program.variables[plant[component].mode].values.size();
    scenario.forced.push_back({Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, cycles))),
                               component,
                               automata::ModeId(up_to(0, values - 1)),
                               {}});
  }
  runtime::ScenarioOptions options;
  options.engine = runtime::ScenarioOptions::Engine::exact;
  const auto engines = make_engines(program, options);
  const auto simulated = engines->simulate(scenario, up_to(0, 1000));
  const auto truth = [&] { return whole(program, seen.marking(*simulated->truth())); };
  MarkedSet before = truth();
  RC_ASSERT(slow.initial().contains(before));
  std::size_t happened = 0;
  reference::MarkingBelief belief = start(slow, {}).belief;
  for (std::size_t cycle = 1; cycle <= cycles; ++cycle) {
    automata::ControlAction action;
    for (const automata::Control& control : plant.controls) {
      action.push_back(ValueId(up_to(0, program.variables[control.variable].values.size() - 1)));
    }
    const auto command = free_command(program, automata::command_of(action));
    const auto possible = slow.next(before, command.values);
    const Ticks now = Ticks::of_seconds(static_cast<std::int64_t>(cycle));
    simulated->issue(action, now);
    if (possible.empty()) {
      RC_ASSERT_THROWS_AS(simulated->sense(now), base::InputError);
      return;
    }
    const automata::Observation observation = simulated->sense(now);
    const MarkedSet after = truth();
    RC_ASSERT(possible.contains(after));
    RC_ASSERT(slow.factor(after, observation) > 0);
    const auto values = slow.values(after);
    for (const auto& event : simulated->happenings()) {
      const auto value = values.find(plant[*event.component].mode);
      RC_ASSERT(value != values.end());
      const auto forced = std::find_if(scenario.forced.begin(), scenario.forced.end(), [&](const auto& one) {
        return one.component == *event.component && one.mode.index() == value->second.index() && one.at <= now;
      });
      RC_ASSERT(forced != scenario.forced.end());
      ++happened;
    }
    const auto& estimate = engines->estimator().update(action, observation, now);
    belief = update(slow, belief, command.values, observation).belief;
    const MarkedSet best = whole(program, seen.marking(estimate.modes));
    RC_ASSERT(std::abs(belief.at(best) - estimate.probability) < 1e-12);
    for (const auto& [marking, probability] : belief) RC_ASSERT(probability < estimate.probability + 1e-12);
    before = after;
  }
  RC_ASSERT(simulated->more_to_come() == (happened < scenario.forced.size()));
}

}  // namespace
}  // namespace rmpl::property
