// Told: faults with time bounds, which are drawn in every step within them (semantics 3).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "automata/step/transition_rules.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

using automata::Component;
using automata::Transition;

namespace {

/// Whether it is one of the outcomes of a transition, others of which are no faults.
bool is_outcome(const Component& component, const Transition& fault) {
  return std::any_of(component.transitions.begin(), component.transitions.end(), [&](const Transition& other) {
    return other.branch == fault.branch && other.from == fault.from && !component.is_fault(other);
  });
}

}  // namespace

void report_timed_faults(PlantReport& report) {
  std::set<grammar::Span> told;  // instances of a type share their transitions
  for (const Component& component : report.plant().components) {
    for (const Transition& transition : component.transitions) {
      if (!component.is_fault(transition) || !transition.timing || !can_ever_be_taken(transition)) continue;
      const grammar::Span span = report.at(transition.origin);
      if (!told.insert(span).second) continue;
      const bool outcome = is_outcome(component, transition);
      const bool spread = transition.timing->density.kind != automata::Density::Kind::uniform;
      auto& finding =
          report.add(grammar::Code::timed_fault, span,
                     "fault " + backquoted(component.modes[transition.to.index()].name) + " of " +
                         backquoted(component.type) + " is drawn in every step that ends within the time bounds" +
                         (outcome  ? ", not when the transition fires"
                          : spread ? ", and the density has no effect"
                                   : ": its probability depends on the cycle"));
      if (!outcome && !spread) finding.severity = grammar::Severity::note;
      finding.suggestion =
          outcome || spread
              ? "let the transition lead to an intermediate mode, and draw the outcome there without time bounds"
              : "to limit when the fault may happen, add a mode that is entered when the bounds begin, and let the "
                "fault leave that mode";
    }
  }
}

}  // namespace rmpl::compiler
