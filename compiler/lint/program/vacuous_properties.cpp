// Properties that hold or fail whatever the plant does.
// SPDX-License-Identifier: MIT
#include <string>

#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/program/possibilities.hpp"
#include "compiler/lint/program/reachable_modes.hpp"
#include "compiler/lint/program/vacuity.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::PlantProperty;

namespace {

class Judge {
 public:
  explicit Judge(const automata::Plant& plant) : plant_(plant), possible_(plant.variables, &plant) {}

  Possibilities& possible() { return possible_; }

  Vacuity operator()(const PlantProperty& property) {
    const Formula from = conjunction_of(property.from);
    if (!possible_.can_hold(from)) return {"it starts in modes that cannot be together", from};
    if (property.claim == PlantProperty::Claim::response) return response(property);
    // Other claims are about runs, or about more than the plant.
    if (property.claim != PlantProperty::Claim::never && property.claim != PlantProperty::Claim::reach) return {};
    const bool never = property.claim == PlantProperty::Claim::never;
    return decided(possible_, property.formula, never ? "what it excludes" : "what it claims to be reached");
  }

 private:
  Vacuity response(const PlantProperty& property) {
    if (!possible_.can_hold(property.formula)) return {"no state satisfies what it waits for", property.formula};
    if (!possible_.can_fail(property.then)) return {"every state satisfies the answer", negation(property.then)};
    if (!possible_.can_hold(automata::conjunction({property.formula, negation(property.then)}))) {
      return {"what it waits for is an answer already",
              automata::conjunction({property.formula, negation(property.then)})};
    }
    const MayHappen may{property.faults > 0, property.commands != PlantProperty::Commands::none || property.of_program};
    const ReachableModes reach(plant_, property.from, may);
    if (!possible_.can_hold(automata::conjunction({property.formula, reach.formula()}))) {
      return {std::string("the plant never gets to what it waits for") + (may.faults ? "" : " without a fault") +
                  (may.faults || may.commands ? "" : " and") + (may.commands ? "" : " without a command"),
              automata::constant(true)};
    }
    return {};
  }

  const automata::Plant& plant_;
  Possibilities possible_;
};

}  // namespace

void lint_vacuous_properties(const LintInput& input, grammar::Diagnostics& found) {
  if (input.properties.empty() || input.document.plants.empty()) return;
  Judge judge(input.document.plants.front());
  if (!judge.possible().consistent()) return;
  for (const PlantProperty& property : input.properties) {
    tell(judge(property), grammar::Code::vacuous_property, input.places.at(property.origin),
         "property \"" + property.name + "\" says nothing of what the plant does",
         property.claim == PlantProperty::Claim::never ? &property.formula : nullptr, judge.possible(), input, found);
  }
}

}  // namespace rmpl::compiler
