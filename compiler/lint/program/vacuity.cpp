// How claims are told that say nothing.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/vacuity.hpp"

#include <algorithm>

namespace rmpl::compiler {

Vacuity decided(Possibilities& possible, const automata::Formula& formula, const std::string& what) {
  if (!possible.can_hold(formula)) return {"no state satisfies " + what, formula};
  if (!possible.can_fail(formula)) return {"every state satisfies " + what, negation(formula)};
  return {};
}

void tell(const Vacuity& vacuity, grammar::Code code, grammar::Span span, const std::string& claim,
          const automata::Formula* excludes, Possibilities& possible, const LintInput& input,
          grammar::Diagnostics& found) {
  if (vacuity.why.empty()) return;
  auto& finding = add_finding(found, code, span, claim + ": " + vacuity.why);
  if (vacuity.contradicted.is_true()) return;
  constexpr std::size_t shown = 4;
  const auto blamed = possible.blame(vacuity.contradicted);
  // What contradicts itself needs no check.
  if (excludes != nullptr && !blamed.empty() && !possible.can_hold(*excludes)) {
    finding.severity = grammar::Severity::note;
  }
  for (std::size_t b = 0; b < std::min(shown, blamed.size()); ++b) {
    finding.notes.push_back({input.places.at(blamed[b]), "this constraint decides it"});
  }
}

}  // namespace rmpl::compiler
