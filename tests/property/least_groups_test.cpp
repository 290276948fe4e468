// Least groups beside groups of all that decides their steps: the same answer.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>

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

}  // namespace
}  // namespace rmpl::property
