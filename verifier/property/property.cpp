// What can be asked, by name.
// SPDX-License-Identifier: MIT
#include "verifier/property/property.hpp"

#include "base/overloaded.hpp"

namespace rmpl::verifier {

std::string_view name_of(ProgramProperty::Kind kind) {
  using Kind = ProgramProperty::Kind;
  switch (kind) {
    case Kind::goal_conflict:
      return "goal-conflict";
    case Kind::no_plan:
      return "no-plan";
    case Kind::endless_wait:
      return "endless-wait";
    case Kind::termination:
      return "termination";
    case Kind::stuck:
      return "stuck";
    case Kind::undone:
      return "undone";
    case Kind::never:
      return "never";
    case Kind::eventually:
      return "eventually";
    case Kind::response:
      return "response";
    case Kind::finally:
      return "finally";
  }
  return "";
}

std::string name_of(const Property& property) {
  return std::visit(base::Overloaded{[](const Reachability&) { return std::string("reachability"); },
                                     [](const Safety&) { return std::string("safety"); },
                                     [](const Response&) { return std::string("response"); },
                                     [](const Stuck&) { return std::string("stuck"); },
                                     [](const ProgramProperty& p) { return std::string(name_of(p.kind)); }},
                    property);
}

std::vector<automata::Formula> formulas_of(const Property& property) {
  using Formulas = std::vector<automata::Formula>;
  return std::visit(base::Overloaded{[](const Reachability& p) { return Formulas{p.target}; },
                                     [](const Safety& p) { return Formulas{p.never}; },
                                     [](const Response& p) {
                                       return Formulas{p.after, p.then};
                                     },
                                     [](const Stuck&) { return Formulas{}; },
                                     [](const ProgramProperty& p) {
                                       return Formulas{p.formula, p.then};
                                     }},
                    property);
}

}  // namespace rmpl::verifier
