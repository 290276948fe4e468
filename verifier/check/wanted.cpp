// What is looked for in a plant.
// SPDX-License-Identifier: MIT
#include "verifier/check/wanted.hpp"

#include "base/check.hpp"
#include "base/overloaded.hpp"

namespace rmpl::verifier {

using automata::Formula;
using automata::Ticks;

Wanted wanted_of(const Property& property) {
  return std::visit(
      base::Overloaded{[](const Reachability& p) {
                         return Wanted(Target{p.target, p.window, p.fastest});
                       },
                       [](const Safety& p) {
                         return Wanted(Target{p.never, p.window, p.fastest});
                       },
                       [](const Response& p) { return Wanted(p); }, [](const Stuck& p) { return Wanted(p); },
                       [](const ProgramProperty& p) -> Wanted {
                         throw base::InternalError(std::string(name_of(p.kind)) +
                                                   " is asked of a program, not of a plant alone");
                       }},
      property);
}

std::vector<Formula> formulas_of(const Wanted& wanted) {
  return std::visit(base::Overloaded{[](const Target& t) { return std::vector{t.formula}; },
                                     [](const Response& r) {
                                       return std::vector{r.after, r.then};
                                     },
                                     [](const Stuck&) { return std::vector<Formula>{}; }},
                    wanted);
}

std::vector<Ticks> times_of(const Wanted& wanted) {
  std::vector<Ticks> times;
  const auto add = [&](std::optional<Ticks> time) {
    if (time && !time->is_infinite()) times.push_back(*time);
  };
  std::visit(base::Overloaded{[&](const Target& t) {
                                add(t.window.not_before);
                                add(t.window.by);
                              },
                              [&](const Response& r) { add(r.within); }, [](const Stuck&) {}},
             wanted);
  return times;
}

Wanted into(const Part& part, Wanted wanted) {
  std::visit(base::Overloaded{[&](Target& t) { t.formula = part.into(t.formula); },
                              [&](Response& r) {
                                r.after = part.into(r.after);
                                r.then = part.into(r.then);
                              },
                              [](Stuck&) {}},
             wanted);
  return wanted;
}

}  // namespace rmpl::verifier
