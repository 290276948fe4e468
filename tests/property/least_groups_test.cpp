// Least groups beside groups of all that decides their steps: the same answer.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "automata/assignment_text.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/game/strategist.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/engineered.hpp"
#include "tests/property/generate.hpp"

namespace rmpl::property {
namespace {

using runtime::Strategist;
using Cycle = std::optional<automata::Ticks>;

/// Rank, whether the goal lasts, the action; of a goal with one group every entry of the cost, too.
void compare(const automata::Plant& plant, const automata::Formula& goal, const automata::Modes& start, Cycle cycle) {
  automata::PlantStep step(plant);
  const runtime::NominalGraph graph(plant);
  using Relevant = Strategist::Relevant;
  Strategist whole(step, graph, goal, cycle, Relevant::upstream, Strategist::Least::large);
  Strategist least(step, graph, goal, cycle, Relevant::upstream, Strategist::Least::all);
  const Strategist::Answer expected = whole.from(start), found = least.from(start);
  RC_PRE(expected.solved && expected.best);
  std::size_t left_out = 0;
  const auto played = [](const Strategist::Answer& answer) {
    std::size_t count = 0;
    for (const auto& group : answer.groups) count += group.game->arena().components().size();
    return count;
  };
  if (played(found) < played(expected)) left_out = played(expected) - played(found);
  for (const auto& [name, answer] : {std::pair("all", &expected), std::pair("least", &found)}) {
    RC_LOG() << name << ": rank " << static_cast<int>(answer->rank) << (answer->lasts ? " lasts" : "") << " action";
    for (std::size_t i = 0; i < answer->action.size(); ++i) RC_LOG() << ' ' << answer->action[i].value;
    for (const auto& group : answer->groups) {
      const runtime::Cost& cost = group.decision().cost;
      RC_LOG() << "; group of";
      for (const auto c : group.game->arena().components()) RC_LOG() << ' ' << plant[c].name;
      RC_LOG() << " purpose " << static_cast<int>(group.decision().purpose) << " memory "
               << static_cast<int>(group.game->memory()) << " cost " << cost.irreversible << ' ' << cost.lost << ' '
               << cost.worth << ' ' << cost.unbounded << ' ' << cost.time << ' ' << cost.moves << ' ' << cost.disturbed
               << ' ' << cost.commands << ' ' << cost.waits << ' ' << cost.reward;
    }
    RC_LOG() << std::endl;
  }
  RC_TAG(left_out, static_cast<int>(expected.rank));
  RC_ASSERT(found.solved);
  RC_ASSERT(found.rank == expected.rank);
  RC_ASSERT(found.lasts == expected.lasts);
  if (found.bounds_counted != expected.bounds_counted) return;
  RC_ASSERT(found.action == expected.action);
  if (found.groups.size() != 1 || expected.groups.size() != 1) return;
  const runtime::GameDecision &one = expected.groups[0].decision(), &other = found.groups[0].decision();
  RC_ASSERT(one.purpose == other.purpose);
  if (one.purpose != runtime::GameDecision::Purpose::reach) return;
  if (found.groups[0].game->memory() != expected.groups[0].game->memory()) return;
  runtime::Cost a = one.cost, b = other.cost;
  a.reward = b.reward = 0;  // of what each of them has
  RC_ASSERT((a == b));
}

Cycle cycles() { return pick<Cycle>({Cycle(), Cycle(automata::Ticks::of_seconds(1)), Cycle(automata::Ticks{0})}); }

void compare_engineered(std::size_t least_parts, std::size_t most_parts) {
  const Engineered drawn = *engineered(least_parts, most_parts);
  const Cycle cycle = cycles();
  RC_LOG() << rc::toString(drawn) << "cycle " << (cycle ? cycle->count : -1) << std::endl;
  compare(drawn.plant, drawn.goal, drawn.start, cycle);
}

RC_GTEST_PROP(LeastGroups, AnswerAsAllComponentsDo, ()) { compare_engineered(2, 6); }

RC_GTEST_PROP(LeastGroups, AnswerAsAllComponentsDoOnAnyPlant, ()) {
  Shape shape{.max_components = 5, .max_modes = 3, .max_attributes = 6};
  shape.tangled = chance(50);
  shape.commanded = chance(30);
  shape.rewards = chance(50);
  shape.timed = chance(50);
  const Model model = *models(shape);
  const automata::Modes start = *modes_of(model.plant);
  std::vector<automata::VariableId> variables;
  for (const automata::Component& c : model.plant.components) variables.push_back(c.mode);
  const automata::Formula goal = *formulas(model.plant.variables, variables, 1);
  const Cycle cycle = cycles();
  RC_LOG() << rc::toString(model) << to_text(goal, model.plant.variables) << " from";
  for (const automata::ModeId m : start) RC_LOG() << ' ' << m.value;
  RC_LOG() << " cycle " << (cycle ? cycle->count : -1) << std::endl;
  automata::PlantStep step(model.plant);
  RC_PRE(step.possible(start));
  compare(model.plant, goal, start, cycle);
}

/// Parts with a command each, of which some set of two or more never is on together, while fewer of them may be. Each
/// of them can step aside instead, and has a helper that would let it go on another way. The goal asks of some of them
/// to be on, or not to be off.
Engineered draw_rivals() {
  using automata::Formula;
  using automata::ModeId;
  using automata::ValueId;
  Engineered drawn;
  automata::Plant& plant = drawn.plant;
  plant.name = "Rivals";
  std::uint32_t branch = 0;
  const auto add = [&](const std::string& name, const std::vector<std::string>& modes,
                       const std::vector<std::string>& commands) {
    automata::Component component;
    component.name = component.type = name;
    component.mode = plant.variables.add({name, modes});
    component.initial.assign(modes.size(), 0.0);
    component.initial.front() = 1;
    const automata::VariableId out = plant.variables.add({name + ".out", {"no", "yes"}});
    for (std::size_t m = 0; m < modes.size(); ++m)
      component.modes.push_back({modes[m], false, automata::is(out, ValueId(m == 1 ? 1U : 0U)), 0, {}});
    if (chance(20)) component.modes[up_to(0, modes.size() - 1)].reward = chance(50) ? 1 : -1;
    plant.controls.push_back({plant.variables.add({name + ".cmd", commands}), ValueId(0)});
    plant.components.push_back(std::move(component));
    return automata::is(out, ValueId(1));
  };
  const auto told = [&](std::size_t value) { return automata::is(plant.controls.back().variable, ValueId(value)); };
  const auto move = [&](std::size_t from, std::size_t to, Formula guard) {
    const auto timing =
        chance(15) ? std::optional(automata::Timing{automata::Ticks::of_seconds(1), automata::Ticks::of_seconds(3), {}})
                   : std::nullopt;
    plant.components.back().transitions.push_back(
        {ModeId(from), ModeId(to), std::move(guard), timing, {}, branch++, {}});
  };
  std::vector<Formula> on, wanted;
  const std::size_t rivals = chance(15) ? 4 : 3;
  for (std::size_t r = 0; r < rivals; ++r) {
    std::optional<Formula> helped;
    if (chance(25)) {
      helped = add("helper" + std::to_string(r), {"idle", "ready"}, {"none", "help"});
      move(0, 1, told(1));
    }
    on.push_back(add("rival" + std::to_string(r), {"off", "on", "aside"}, {"none", "on", "aside", "off"}));
    const automata::VariableId mode = plant.components.back().mode;
    move(0, 1, told(1));
    move(0, 2, helped && chance(50) ? automata::conjunction({told(2), *helped}) : told(2));
    move(2, 1, helped ? automata::conjunction({told(1), *helped}) : told(1));
    move(1, 0, told(3));
    if (chance(80)) move(2, 0, told(3));
    drawn.start.resize(plant.components.size());
    drawn.start.back() = ModeId(chance(80) ? 0 : 2);
    if (chance(85))
      wanted.push_back(chance(60) ? automata::is(mode, ValueId(1))
                                  : automata::negation(automata::is(mode, ValueId(0))));
  }
  on.resize(chance(70) ? 3 : up_to(2, rivals), automata::constant(true));
  plant.interconnections.emplace_back(automata::negation(automata::conjunction(std::move(on))));
  drawn.goal = automata::conjunction(std::move(wanted));
  return drawn;
}

RC_GTEST_PROP(LeastGroups, AnswerAsAllComponentsDoWhereSeveralExcludeEachOther, ()) {
  const Engineered drawn = draw_rivals();
  const Cycle cycle = cycles();
  RC_LOG() << rc::toString(drawn) << "cycle " << (cycle ? cycle->count : -1) << std::endl;
  compare(drawn.plant, drawn.goal, drawn.start, cycle);
}

}  // namespace
}  // namespace rmpl::property
