// What lint takes for impossible in random model programs, against all their markings, worlds and stores one by one.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "automata/step/marking_rules.hpp"
#include "automata/step/marking_store.hpp"
#include "compiler/lint/model_program/entailment.hpp"
#include "compiler/lint/model_program/reachable_markings.hpp"
#include "compiler/lint/model_program/told_stores.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/generate_model_program.hpp"
#include "tests/property/generate_software.hpp"
#include "tests/reference/marking_reach.hpp"
#include "tests/reference/model_program.hpp"

namespace rmpl::property {
namespace {

using automata::Assignment;
using automata::Formula;
using automata::LocationId;
using automata::ModelProgram;
using automata::ValueId;
using automata::VariableId;

std::vector<VariableId> all_of(const automata::Variables& table) {
  std::vector<VariableId> all;
  for (std::size_t v = 0; v < table.size(); ++v) all.emplace_back(v);
  return all;
}

bool holds_in(const std::vector<Assignment>& world, const Formula& formula) {
  return evaluate(formula, [&](VariableId variable) { return world[variable.index()].value; });
}

/// Whether what stands with these formulas has a world, and whether the formula holds in all of them.
std::pair<bool, bool> judged(const std::vector<std::vector<Assignment>>& worlds, const std::vector<Formula>& store,
                             const Formula& formula) {
  bool consistent = false;
  bool entailed = true;
  for (const auto& world : worlds) {
    if (!std::all_of(store.begin(), store.end(), [&](const Formula& one) { return holds_in(world, one); })) continue;
    consistent = true;
    entailed = entailed && holds_in(world, formula);
  }
  return {consistent, entailed};
}

struct StoreCase {
  compiler::StorePart part;
  Formula formula;
  std::vector<bool> marked;
};

StoreCase store_case() {
  StoreCase made;
  for (std::size_t v = up_to(1, 4); v > 0; --v) {
    made.part.variables.add({"v" + std::to_string(v), {"a", "b", "c"}});
  }
  const auto variables = all_of(made.part.variables);
  const auto formula = [&] { return *formulas(made.part.variables, variables, 1); };
  for (std::size_t s = up_to(0, 2); s > 0; --s) made.part.standing.push_back(formula());
  const std::size_t tellable = up_to(0, 5);
  for (std::size_t t = 0; t < tellable; ++t) {
    made.part.tellable.emplace_back(LocationId(t), formula());
    made.marked.push_back(chance(80));
  }
  for (const VariableId v : variables) {
    if (chance(25)) made.part.free.push_back(v);
  }
  made.formula = formula();
  return made;
}

/// Every subset of what may be told, with every value of what is free.
bool some_store_entails(const StoreCase& given) {
  const auto worlds = all_assignments(given.part.variables, all_of(given.part.variables));
  const auto& tellable = given.part.tellable;
  for (std::size_t subset = 0; subset < std::size_t{1} << tellable.size(); ++subset) {
    std::vector<Formula> store = given.part.standing;
    bool may = true;
    for (std::size_t t = 0; t < tellable.size(); ++t) {
      if ((subset >> t & 1) == 0) continue;
      may = may && given.marked[t];
      store.push_back(tellable[t].second);
    }
    if (!may) continue;
    for (const auto& free : all_assignments(given.part.variables, given.part.free)) {
      std::vector<Formula> commanded = store;
      commanded.push_back(conjunction_of(free));
      const auto [consistent, entailed] = judged(worlds, commanded, given.formula);
      if (consistent && entailed) return true;
    }
  }
  return false;
}

RC_GTEST_PROP(LintOfModelPrograms, KnowsWhetherSomeStoreEntails, ()) {
  const StoreCase given = store_case();
  const auto worlds = all_assignments(given.part.variables, all_of(given.part.variables));
  compiler::Entailment entailment(given.part, given.formula);
  RC_ASSERT(entailment.may_fail() == !judged(worlds, given.part.standing, given.formula).second);
  RC_ASSERT(entailment.may_hold(given.marked) == some_store_entails(given));
}

RC_GTEST_PROP(LintOfModelPrograms, TakesForImpossibleOnlyWhatNeverIs, ()) {
  const ModelProgram program = (*model_programs(5)).program;
  compiler::ToldStores stores(program);
  if (stores.contradiction()) return;
  const std::vector<bool> reached = compiler::reachable_locations(program, stores);
  std::vector<VariableId> controls;
  for (const automata::CommandedVariable& control : program.controls) controls.push_back(control.variable);
  const auto commands = all_assignments(program.variables, controls);
  const reference::ModelProgramStep slow(program);
  constexpr std::size_t steps = 4;
  const automata::MarkingRules rules(program);
  automata::MarkingStore store(program, rules.conditions());
  for (const auto& layer : reference::marking_layers(slow, commands, steps)) {
    for (const auto& [marking, improbable] : layer) {
      automata::Marking primitive;
      for (const LocationId l : marking) {
        RC_ASSERT(reached[l.index()]);
        if (!program.locations[l.index()].composite) primitive.push_back(l);
      }
      for (const auto& given : commands) {
        const automata::Command command = automata::command_from(program, given);
        if (!store.permits(primitive, command)) continue;
        for (std::size_t c = 0; c < rules.conditions().size(); ++c) {
          const compiler::Freedom free = stores.freedom(rules.conditions()[c], reached);
          RC_ASSERT((store.holds(c, primitive, command) ? free.may_hold : free.may_fail));
        }
      }
    }
  }
}

RC_GTEST_PROP(LintOfModelPrograms, BlamesWhatContradictsItself, ()) {
  const ModelProgram program = (*model_programs(5)).program;
  compiler::ToldStores stores(program);
  const auto worlds = all_assignments(program.variables, all_of(program.variables));
  if (stores.contradiction()) return;
  for (const auto& together : compiler::started_together(program)) {
    compiler::ToldContradiction all{together, {}};
    for (std::size_t c = 0; c < program.constraints.size(); ++c) all.standing.push_back(c);
    const auto is_possible = [&](const compiler::ToldContradiction& some) {
      std::vector<Formula> store;
      for (const std::size_t standing : some.standing) store.push_back(program.constraints[standing].constraint);
      for (const LocationId l : some.told) store.push_back(program.locations[l.index()].told);
      return judged(worlds, store, automata::constant(true)).first;
    };
    const auto blamed = stores.contradiction(together);
    RC_ASSERT(blamed.has_value() == !is_possible(all));
    if (!blamed) continue;
    RC_ASSERT(!is_possible(*blamed));
    for (const LocationId l : blamed->told) RC_ASSERT(std::count(together.begin(), together.end(), l) == 1);
  }
}

}  // namespace
}  // namespace rmpl::property
