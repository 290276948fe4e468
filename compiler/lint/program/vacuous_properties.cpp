// Properties that hold or fail whatever the plant does.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <vector>

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
    if (!possible_.can_hold(from)) return {"the modes after `from` contradict each other", from};
    if (property.claim == PlantProperty::Claim::response) return response(property);
    // Other claims are about runs, or about more than the plant.
    if (property.claim != PlantProperty::Claim::never && property.claim != PlantProperty::Claim::reach) return {};
    const std::string what =
        property.claim == PlantProperty::Claim::never ? "the formula after `never`" : "the formula after `reach`";
    const Vacuity vacuity = decided(possible_, property.formula, what);
    if (!vacuity.why.empty() || property.faults > 0) return vacuity;
    const auto may_come = [&](bool faults) {
      const ReachableModes reach(plant_, property.from, {faults, true});
      return possible_.can_hold(automata::conjunction({property.formula, reach.formula()}));
    };
    if (may_come(false) || !may_come(true)) return {};
    return {what + " needs a fault, but none is permitted: `faults K` permits up to K", automata::constant(true)};
  }

 private:
  Vacuity response(const PlantProperty& property) {
    if (!possible_.can_hold(property.formula)) return {"no state satisfies the trigger", property.formula};
    if (!possible_.can_fail(property.then)) return {"every state satisfies the response", negation(property.then)};
    if (!possible_.can_hold(automata::conjunction({property.formula, negation(property.then)}))) {
      return {"every state with the trigger satisfies the response",
              automata::conjunction({property.formula, negation(property.then)})};
    }
    const MayHappen may{property.faults > 0, property.commands != PlantProperty::Commands::none || property.of_program};
    const ReachableModes reach(plant_, property.from, may);
    if (!possible_.can_hold(automata::conjunction({property.formula, reach.formula()}))) {
      return {std::string("the plant never reaches the trigger") + (may.faults ? "" : " without a fault") +
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
  const auto& plants = input.document.plants;
  std::map<std::size_t, Judge> judges;
  const auto judge_of = [&](const PlantProperty& property) -> Judge* {
    if (property.plant >= plants.size()) return nullptr;
    Judge& judge = judges.try_emplace(property.plant, plants[property.plant]).first->second;
    return judge.possible().consistent() ? &judge : nullptr;
  };
  // One that speaks of several plants says something where it does of one of them.
  std::map<std::tuple<std::string, std::uint32_t, std::uint32_t>, std::vector<const PlantProperty*>> by_place;
  for (const PlantProperty& property : input.properties) {
    by_place[{property.origin.file, property.origin.line, property.origin.column}].push_back(&property);
  }
  for (const auto& [place, same] : by_place) {
    Judge* judge = nullptr;
    const bool says_nothing = std::all_of(same.begin(), same.end(), [&](const PlantProperty* property) {
      Judge* const own = judge_of(*property);
      if (own == nullptr || (*own)(*property).why.empty()) return false;
      if (judge == nullptr) judge = own;
      return true;
    });
    if (!says_nothing) continue;
    const PlantProperty& property = *same.front();
    tell((*judge)(property), grammar::Code::vacuous_property, input.places.at(property.origin),
         "property \"" + property.name + "\" does not depend on what the plant does",
         property.claim == PlantProperty::Claim::never ? &property.formula : nullptr, judge->possible(), input, found);
  }
}

}  // namespace rmpl::compiler
