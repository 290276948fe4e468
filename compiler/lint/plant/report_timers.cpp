// Told: transitions from a mode to itself beside an exit that its clock decides. They do not restart the clock
// (semantics 3), which is what most who write one mean by it.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/plant/nominal.hpp"
#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

using automata::Component;
using automata::Transition;

namespace {

/// The first exit to another mode that the clock decides; null where there is none.
const Transition* timed_exit(const Component& component, automata::ModeId mode) {
  const auto found =
      std::find_if(component.transitions.begin(), component.transitions.end(), [&](const Transition& other) {
        return other.from == mode && other.to != mode && other.timing && !component.is_fault(other) &&
               !other.timing->memoryless();
      });
  return found == component.transitions.end() ? nullptr : &*found;
}

}  // namespace

void report_timers(PlantReport& report) {
  std::set<grammar::Span> told;
  for (const grammar::Diagnostic& finding : report.told()) {
    if (finding.code == grammar::Code::idle_transition) told.insert(finding.span);
  }
  const auto loops =
      nominal_where(report.analysis(), [](const Component& component, const Transition& own, PlantTransition) {
        return own.from == own.to && !own.restart && timed_exit(component, own.from) != nullptr;
      });
  for (const PlantTransition& loop : loops) {
    const grammar::Span span = report.at(loop);
    if (!told.insert(span).second) continue;
    const Component& component = report.plant()[loop.component];
    const Transition& own = report[loop];
    const Transition& exit = *timed_exit(component, own.from);
    const std::string mode = component.modes[own.from.index()].name;
    const std::string target = backquoted(component.modes[exit.to.index()].name);
    auto& finding =
        report.add(grammar::Code::timer_goes_on, span,
                   "the transition from " + backquoted(mode) + " of " + backquoted(component.type) +
                       " to the same mode does not restart its clock: the time to " + target + " continues");
    finding.notes.push_back({report.at(exit.origin), "this exit counts from the entry into " + backquoted(mode)});
    finding.suggestion =
        own.timing ? "a clock starts when its mode is entered from another mode: go through an intermediate mode"
                   : "write `" + mode + " -> " + mode + " restart when …` to restart the clock";
  }
}

}  // namespace rmpl::compiler
