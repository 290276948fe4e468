// Claims of files as properties.
// SPDX-License-Identifier: MIT
#include "verifier/claims/stated_property.hpp"

#include "base/check.hpp"
#include "base/error.hpp"

namespace rmpl::verifier {

using automata::PlantProperty;

namespace {

ProgramProperty::Kind kind_of(PlantProperty::Claim claim) {
  using Claim = PlantProperty::Claim;
  using Kind = ProgramProperty::Kind;
  switch (claim) {
    case Claim::never:
      return Kind::never;
    case Claim::response:
      return Kind::response;
    case Claim::eventually:
      return Kind::eventually;
    case Claim::finally:
      return Kind::finally;
    case Claim::stuck:
      return Kind::stuck;
    case Claim::goal_conflict:
      return Kind::goal_conflict;
    case Claim::no_plan:
      return Kind::no_plan;
    case Claim::endless_wait:
      return Kind::endless_wait;
    case Claim::termination:
      return Kind::termination;
    case Claim::undone:
      return Kind::undone;
    case Claim::reach:
    case Claim::probability:
      break;
  }
  throw base::InternalError("what can be reached is asked of a plant alone, and a probability of no search");
}

}  // namespace

Property property_of(const PlantProperty& stated, const automata::Plant& plant) {
  if (stated.of_program) {
    ProgramProperty asked{.kind = kind_of(stated.claim)};
    const auto text = [&](const automata::Formula& formula) {
      return formula == automata::constant(true) ? "" : to_text(formula, plant.variables);
    };
    asked.formula = stated.formula;
    asked.within = stated.within;
    asked.text = text(stated.formula);
    asked.then = stated.then;
    asked.then_text = text(stated.then);
    return asked;
  }
  switch (stated.claim) {
    case PlantProperty::Claim::never:
      return Safety{stated.formula, {}, false};
    case PlantProperty::Claim::reach:
      return Reachability{stated.formula, {}, false};
    case PlantProperty::Claim::stuck:
      return Stuck{};
    default:
      return Response{stated.formula, stated.then, stated.within};
  }
}

}  // namespace rmpl::verifier
