// Properties that hold or fail whatever the plant does.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/program/possibilities.hpp"
#include "compiler/lint/program/reachable_modes.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::PlantProperty;

namespace {

/// Why a property says nothing; with the formula that the constraints decide, where they do.
struct Vacuity {
  std::string why;
  Formula contradicted = automata::constant(true);
};

class Judge {
 public:
  explicit Judge(const automata::Plant& plant) : plant_(plant), possible_(plant.variables, &plant) {}

  bool consistent() { return possible_.consistent(); }
  bool can_hold(const Formula& formula) { return possible_.can_hold(formula); }
  std::vector<automata::Origin> blame(const Formula& formula) { return possible_.blame(formula); }

  Vacuity operator()(const PlantProperty& property) {
    const Formula from = conjunction_of(property.from);
    if (!possible_.can_hold(from)) return {"it starts in modes that cannot be together", from};
    if (property.claim == PlantProperty::Claim::response) return response(property);
    // Other claims are about runs, or about more than the plant.
    if (property.claim != PlantProperty::Claim::never && property.claim != PlantProperty::Claim::reach) return {};
    const bool never = property.claim == PlantProperty::Claim::never;
    if (!possible_.can_hold(property.formula)) {
      return {never ? "no state satisfies what it excludes" : "no state satisfies what it claims to be reached",
              property.formula};
    }
    if (!possible_.can_fail(property.formula)) {
      return {never ? "every state satisfies what it excludes" : "every state satisfies what it claims to be reached",
              negation(property.formula)};
    }
    return {};
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
  if (!judge.consistent()) return;
  for (const PlantProperty& property : input.properties) {
    const Vacuity vacuity = judge(property);
    if (vacuity.why.empty()) continue;
    auto& finding =
        add_finding(found, grammar::Code::vacuous_property, input.places.at(property.origin),
                    "property \"" + property.name + "\" says nothing of what the plant does: " + vacuity.why);
    if (vacuity.contradicted.is_true()) continue;
    constexpr std::size_t shown = 4;
    const auto blamed = judge.blame(vacuity.contradicted);
    // That the constraints alone exclude something may be what is to be checked; what contradicts itself needs no
    // check.
    const bool excluded = property.claim == PlantProperty::Claim::never && !judge.can_hold(property.formula);
    if (excluded && !blamed.empty()) finding.severity = grammar::Severity::note;
    for (std::size_t b = 0; b < std::min(shown, blamed.size()); ++b) {
      finding.notes.push_back({input.places.at(blamed[b]), "this decides it"});
    }
  }
}

}  // namespace rmpl::compiler
