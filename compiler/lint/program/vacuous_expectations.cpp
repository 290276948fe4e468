// Expectations that are met or fail whatever is flown.
// SPDX-License-Identifier: MIT
#include <map>
#include <utility>

#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/program/possibilities.hpp"
#include "compiler/lint/program/reachable_modes.hpp"
#include "compiler/lint/program/vacuity.hpp"

namespace rmpl::compiler {

using automata::Expectation;
using automata::Scenario;

namespace {

Vacuity vacuity_of(const Expectation& expectation, const Scenario& scenario, const automata::Plant& plant,
                   Possibilities& possible) {
  if (expectation.after) {
    if (!possible.can_hold(*expectation.after)) {
      return {"no state satisfies the condition after `after`", *expectation.after};
    }
    const ReachableModes reach(plant, added_modes(scenario, plant));
    if (!possible.can_hold(automata::conjunction({*expectation.after, reach.formula()}))) {
      return {"the plant never satisfies the condition after `after`", automata::constant(true)};
    }
  }
  switch (expectation.kind) {
    case Expectation::Kind::never:
      return decided(possible, expectation.condition, "the excluded condition");
    case Expectation::Kind::eventually: {
      Vacuity vacuity = decided(possible, expectation.condition, "the expected condition");
      // That every state satisfies it still says that what it comes after comes.
      const bool waits = expectation.after && possible.can_hold(expectation.condition);
      return waits ? Vacuity{} : vacuity;
    }
    case Expectation::Kind::finished:
      if (possible.can_hold(expectation.condition)) return {};
      return {"no state satisfies the expected condition", expectation.condition};
    case Expectation::Kind::never_finished:
      if (possible.can_hold(expectation.condition)) return {};
      return {"no state satisfies the excluded condition", expectation.condition};
    case Expectation::Kind::goal_conflict:
    case Expectation::Kind::no_plan:
      return {};
  }
  return {};
}

}  // namespace

void lint_vacuous_expectations(const LintInput& input, grammar::Diagnostics& found) {
  std::map<std::size_t, Possibilities> by_plant;
  for (const Scenario& scenario : input.document.scenarios) {
    if (scenario.expectations.empty()) continue;
    const automata::Plant& plant = input.document.plants[scenario.plant];
    Possibilities& possible = by_plant.try_emplace(scenario.plant, plant.variables, &plant).first->second;
    if (!possible.consistent()) continue;
    for (const Expectation& expectation : scenario.expectations) {
      tell(vacuity_of(expectation, scenario, plant, possible), grammar::Code::vacuous_expectation,
           input.places.at(expectation.origin), "the expectation does not depend on the flight",
           expectation.kind == Expectation::Kind::never ? &expectation.condition : nullptr, possible, input, found);
    }
  }
}

}  // namespace rmpl::compiler
