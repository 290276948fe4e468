// What lint finds in random programs, against all their markings one by one.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "compiler/lint/program/goal_threads.hpp"
#include "compiler/lint/program/marking_search.hpp"
#include "compiler/lint/program/meeting_goals.hpp"
#include "compiler/lint/program/possibilities.hpp"
#include "compiler/lint/program/reachable_locations.hpp"
#include "compiler/lint/program/reachable_modes.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/markings.hpp"
#include "tests/reference/models.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;

/// A small plant all of which is seen, and a program for it.
std::pair<automata::Plant, automata::Program> small_case() {
  Shape shape;
  shape.max_components = 2;
  shape.max_modes = 2;
  shape.max_attributes = 2;
  shape.timed = false;
  automata::Plant plant = (*models(shape)).plant;
  std::set<automata::VariableId> modes;
  for (const automata::Component& component : plant.components) modes.insert(component.mode);
  plant.observables.clear();
  for (const automata::VariableId variable : all_variables(plant)) {
    if (!modes.count(variable)) plant.observables.push_back(variable);
  }
  automata::Program program = (*programs(plant)).program;
  return {std::move(plant), std::move(program)};
}

/// Readings between and at the bounds that random programs have: whole seconds up to 3.
std::vector<Ticks> all_readings() {
  std::vector<Ticks> readings;
  for (int half = 1; half <= 7; ++half) readings.push_back({half * Ticks::per_second / 2});
  return readings;
}

std::optional<reference::MarkingsFound> twin(const automata::Plant& plant, const automata::Program& program) {
  constexpr std::size_t limit = 1'500;
  return reference::all_markings(program, plant, all_readings(), limit);
}

constexpr compiler::SearchLimits wide{200'000, 2'000'000, 64};

std::optional<std::size_t> first_cycle(const std::vector<compiler::GoalClash>& clashes) {
  std::optional<std::size_t> first;
  for (const compiler::GoalClash& clash : clashes) first = std::min(first.value_or(clash.cycle), clash.cycle);
  return first;
}

RC_GTEST_PROP(LintOfPrograms, FindsContradictingGoalsWhereThereAreSome, ()) {
  const auto [plant, program] = small_case();
  const auto slow = twin(plant, program);
  if (!slow) return;
  const std::vector<bool> all(program.locations.size(), true);
  compiler::FreeConditions conditions(program, &plant);
  RC_ASSERT(first_cycle(compiler::find_goal_clashes(program, conditions, all, wide)) == slow->contradiction);
}

RC_GTEST_PROP(LintOfPrograms, FollowsThePlantFromItsStart, ()) {
  const auto [plant, program] = small_case();
  const auto stages = reference::modes_by_cycle(plant);
  const auto slow = reference::all_markings(program, plant, all_readings(), 1'500, stages);
  if (!slow) return;
  const std::vector<bool> all(program.locations.size(), true);
  compiler::FreeConditions conditions(program, &plant, compiler::ReachableModes::by_cycle(plant, {}));
  RC_ASSERT(first_cycle(compiler::find_goal_clashes(program, conditions, all, wide)) == slow->contradiction);
  const auto free = twin(plant, program);
  if (free) RC_TAG(free->contradiction == slow->contradiction ? "as of any plant" : "later, or never");
}

RC_GTEST_PROP(LintOfPrograms, LeavesOutOnlyWhatDecidesNothing, ()) {
  const auto [plant, program] = small_case();
  const auto slow = twin(plant, program);
  if (!slow) return;
  std::optional<std::size_t> first;
  compiler::FreeConditions conditions(program, &plant);
  for (const automata::VariableId component : compiler::components_of_meeting_goals(program)) {
    const auto relevant = compiler::goal_threads(program, component);
    for (const compiler::GoalClash& clash : compiler::find_goal_clashes(program, conditions, relevant, wide)) {
      first = std::min(first.value_or(clash.cycle), clash.cycle);
    }
  }
  RC_ASSERT(first == slow->contradiction);
}

RC_GTEST_PROP(LintOfPrograms, CallsOnlyThatUnreachableWhichIsNeverMarked, ()) {
  const auto [plant, program] = small_case();
  const auto slow = twin(plant, program);
  if (!slow) return;
  compiler::Possibilities possible(program.variables, &plant);
  if (!possible.consistent()) return;
  const auto freedom = [&](const automata::Condition& condition) -> compiler::Freedom {
    compiler::Freedom free{possible.can_hold(condition.constraint), possible.can_fail(condition.constraint)};
    if (!condition.entailed) std::swap(free.may_hold, free.may_fail);
    return free;
  };
  const compiler::ReachableLocations reach(compiler::flow_of(program, freedom));
  for (const automata::LocationId marked : slow->marked) RC_ASSERT(reach.reached(marked));
}

RC_GTEST_PROP(LintOfPrograms, JudgesConditionsAsTheModelsDo, ()) {
  const Model model = *models();
  const automata::Formula formula = *formulas(model.plant.variables, all_variables(model.plant), 2);
  const reference::Models all(model.plant);
  compiler::Possibilities possible(model.plant.variables, &model.plant);
  RC_ASSERT(possible.can_hold(formula) == all.allows({}, formula));
  RC_ASSERT(possible.can_fail(formula) == !all.entails({}, formula));
}

}  // namespace
}  // namespace rmpl::property
