// The constraint store and the step function against enumeration.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "automata/logic/theory.hpp"
#include "automata/step/plain_step.hpp"
#include "automata/step/plant_step.hpp"
#include "automata/store/relevance.hpp"
#include "automata/store/value_set.hpp"
#include "base/bounded_cache.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/engineered.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/models.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::property {
namespace {

using automata::Assignment;
using automata::ComponentId;
using automata::Ticks;

/// The store of a plant as the fast code has it: Q, and each mode's constraint under its mode.
void tell(automata::Theory& theory, const automata::Plant& plant) {
  for (const auto& q : plant.interconnections) theory.tell(q.constraint);
  for (const auto& component : plant.components)
    for (std::size_t mode = 0; mode < component.modes.size(); ++mode)
      theory.tell_if({component.mode, automata::ValueId(mode)}, component.modes[mode].constraint);
}

/// Questions to one theory, each much like the one before or not at all.
void compare_with_enumeration(automata::Theory::Upkeep upkeep, int questions) {
  const Model model = *models();
  const automata::Variables& variables = model.plant.variables;
  automata::Theory theory(variables, upkeep);
  tell(theory, model.plant);
  const reference::Models enumeration(model.plant);
  for (int question = 0; question < questions; ++question) {
    const auto formula = *formulas(variables, all_variables(model.plant));
    const auto assumptions = *partial_assignments(variables);
    const auto handle = theory.encode(formula);
    const bool consistent = theory.consistent(assumptions);
    RC_ASSERT(consistent == enumeration.consistent(assumptions));
    if (consistent) {
      if (theory.known_to_follow(handle)) RC_ASSERT(enumeration.entails(assumptions, formula));
      // The model found is one.
      std::vector<Assignment> world;
      for (const automata::VariableId v : all_variables(model.plant)) world.push_back({v, theory.value(v)});
      for (const Assignment a : assumptions) RC_ASSERT(std::find(world.begin(), world.end(), a) != world.end());
      RC_ASSERT(enumeration.allows(world, formula) == theory.holds(handle));
      RC_ASSERT(enumeration.consistent(world));
    } else {
      const std::vector<Assignment> conflict = theory.conflict();
      for (Assignment blamed : conflict)
        RC_ASSERT(std::find(assumptions.begin(), assumptions.end(), blamed) != assumptions.end());
      RC_ASSERT(!enumeration.consistent(conflict));
    }
    RC_ASSERT(theory.allows(assumptions, handle) == enumeration.allows(assumptions, formula));
    const bool entailed = theory.entails(assumptions, handle);
    RC_ASSERT(entailed == enumeration.entails(assumptions, formula));
    if (entailed) RC_ASSERT(enumeration.entails(theory.conflict(), formula));
  }
}

RC_GTEST_PROP(Logic, TheoryIsEnumeration, ()) { compare_with_enumeration(automata::Theory::Upkeep::searched, 6); }

RC_GTEST_PROP(Logic, MaintainedTheoryIsEnumeration, ()) {
  compare_with_enumeration(automata::Theory::Upkeep::maintained, 24);
}

bool same(const std::vector<std::vector<automata::Move>>& one, const std::vector<std::vector<automata::Move>>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const automata::Move& m, const automata::Move& n) {
      return m.mode == n.mode && m.probability == n.probability;
    });
  });
}

void compare_steps() {
  const Model model = *models();
  automata::PlantStep fast(model.plant);
  automata::PlainStep plain(model.plant);
  const reference::Step slow(model.plant);
  for (int question = 0; question < 6; ++question) {
    automata::SystemState state{*modes_of(model.plant), {}};
    RC_ASSERT(fast.possible(state.modes) == slow.possible(state.modes));
    RC_ASSERT(plain.possible(state.modes) == slow.possible(state.modes));
    if (!slow.possible(state.modes)) continue;
    const auto half_seconds = [](std::size_t n) { return Ticks{static_cast<std::int64_t>(n) * Ticks::per_second / 2}; };
    const Ticks before = half_seconds(up_to(0, 12));
    const Ticks now = before + half_seconds(up_to(1, 6));
    for (std::size_t i = 0; i < state.modes.size(); ++i)
      state.clock_starts.push_back(
          half_seconds(up_to(0, static_cast<std::size_t>(before.count / (Ticks::per_second / 2)))));
    const auto action = *actions_of(model.plant);
    const auto moves = fast.moves(state, action, before, now);
    RC_ASSERT(same(moves, plain.moves(state, action, before, now)));
    for (std::size_t i = 0; i < state.modes.size(); ++i) {
      const auto expected = slow.distribution(i, state, action, before, now);
      std::vector<double> found(expected.size(), 0.0);
      for (const automata::Move& move : moves[i]) {
        RC_ASSERT(move.probability > 0);
        found[move.mode.index()] += move.probability;
      }
      for (std::size_t mode = 0; mode < expected.size(); ++mode)
        RC_ASSERT(std::abs(found[mode] - expected[mode]) < 1e-9);
    }
    automata::Observation observation;
    for (Assignment a : *partial_assignments(model.plant.variables))
      if (!model.plant.component_of(a.variable)) observation.push_back(a);
    RC_ASSERT(plain.store().explains(state.modes, observation) == slow.explains(state.modes, observation));
    RC_ASSERT(fast.explains(state.modes, observation) == slow.explains(state.modes, observation));
    RC_ASSERT(std::abs(fast.observation_factor(state.modes, observation) -
                       slow.observation_factor(state.modes, observation)) < 1e-12);
  }
}

RC_GTEST_PROP(Logic, StepIsItsDefinition, ()) { compare_steps(); }

RC_GTEST_PROP(Logic, StepIsItsDefinitionWithoutCaches, ()) {
  const base::WithoutCaches forgetful;
  compare_steps();
}

bool alike(const automata::Enabled& one, const automata::Enabled& other) {
  return one.faults == other.faults && one.untimed == other.untimed && one.timed == other.timed;
}

/// What a command leaves consistent and enables, asked of islands in which it and what single modes tell are known, is
/// what the plain store says.
void compare_commands(const automata::Plant& plant) {
  automata::PlantStep fast(plant);
  automata::PlainStep plain(plant);
  for (int question = 0; question < 12; ++question) {
    const automata::Modes modes = *modes_of(plant);
    const automata::ControlAction action = *actions_of(plant);
    const bool consistent = plain.store().consistent(modes, action);
    RC_ASSERT(fast.consistent(modes, action) == consistent);
    if (!consistent) continue;
    const std::vector<automata::Enabled> expected = plain.enabled(modes, action);
    const automata::AllEnabled* enabled = fast.enabled_if_permitted(modes, action);
    RC_ASSERT(enabled != nullptr);
    for (std::size_t c = 0; c < modes.size(); ++c) {
      RC_ASSERT(alike((*enabled)[c], expected[c]));
      RC_ASSERT(alike(fast.enabled(automata::ComponentId(c), modes, action), expected[c]));
    }
  }
}

RC_GTEST_PROP(Logic, StoreOfACommandIsThePlainOne, ()) { compare_commands((*models({.tangled = true})).plant); }
RC_GTEST_PROP(Logic, StoreOfACommandIsThePlainOneWhereItIsEngineered, ()) { compare_commands((*engineered()).plant); }

/// Values that the constraints of a part permit are those that the whole store permits.
RC_GTEST_PROP(Logic, PartsOfAStoreSayWhatItSays, ()) {
  const Model model = *models();
  automata::Relevance relevance(model.plant);
  const reference::Models whole(model.plant);
  if (!whole.consistent({})) return;
  for (int question = 0; question < 6; ++question) {
    std::vector<automata::VariableId> of;
    for (std::size_t i = up_to(1, 2); i > 0; --i) of.push_back(pick(all_variables(model.plant)));
    const automata::Relevance::Part part = relevance.part(of);
    for (int draw = 0; draw < 8; ++draw) {
      reference::World world(model.plant.variables.size());
      std::vector<Assignment> values;
      for (const automata::VariableId v : part.variables) {
        world[v.index()] = automata::ValueId(up_to(0, model.plant.variables[v].values.size() - 1));
        values.push_back({v, world[v.index()]});
      }
      const bool permitted = std::all_of(part.constraints.begin(), part.constraints.end(), [&](std::size_t position) {
        const automata::Constraint& told = relevance.constraints()[position];
        const bool counts = !told.under || world[told.under->variable.index()] == told.under->value;
        return !counts || reference::holds(told.formula, world);
      });
      RC_ASSERT(permitted == whole.consistent(values));
    }
  }
}

/// The values that formulas leave a variable are those with which they hold.
RC_GTEST_PROP(ValuesLeft, AreThoseThatHold, ()) {
  const Model model = *models();
  const automata::Variables& variables = model.plant.variables;
  reference::World world(variables.size());
  for (std::size_t v = 0; v < world.size(); ++v) {
    world[v] = automata::ValueId(up_to(0, variables[automata::VariableId(v)].values.size() - 1));
  }
  const automata::VariableId of(up_to(0, variables.size() - 1));
  const auto parts = *rc::gen::container<std::vector<automata::Formula>>(
      up_to(0, 3), formulas(variables, all_variables(model.plant), 3));
  const automata::ValueSet left =
      automata::values_left(parts, of, [&](automata::VariableId v) { return world[v.index()]; });
  std::size_t count = 0;
  std::optional<automata::ValueId> first;
  for (std::size_t value = 0; value < variables[of].values.size(); ++value) {
    world[of.index()] = automata::ValueId(value);
    const auto holds = [&](const automata::Formula& part) { return reference::holds(part, world); };
    if (!std::all_of(parts.begin(), parts.end(), holds)) continue;
    if (count++ == 0) first = automata::ValueId(value);
  }
  RC_ASSERT(left.size(variables[of].values.size()) == count);
  if (first) RC_ASSERT(left.first() == first);
}

}  // namespace
}  // namespace rmpl::property
