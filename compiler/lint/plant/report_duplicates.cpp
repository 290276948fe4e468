// Told once more, with a fix: transitions given twice of which the second has no effect.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::Transition;
using automata::ValueId;
using automata::Weight;

namespace {

/// Whether it is taken as soon as it is enabled, and draws from what else is.
bool is_plain(const Component& component, const Transition& transition) {
  return !component.is_fault(transition) && !transition.timing && transition.weight.kind == Weight::Kind::none;
}

/// Whether a branch is in a transition as written.
bool is_in(grammar::Span transition, grammar::Span branch) {
  return transition.file == branch.file && transition.begin <= branch.begin && branch.end <= transition.end;
}

class Duplicates {
 public:
  Duplicates(PlantReport& report, grammar::Span first, grammar::Span second)
      : report_(report), first_(first), second_(second) {}

  /// Whether without the second the plant does the same: with both the first is drawn twice as often from what is
  /// enabled, so nothing else may be.
  bool has_no_effect() {
    bool any = false;
    for (std::size_t c = 0; c < report_.plant().components.size(); ++c) {
      const Component& component = report_.plant().components[c];
      for (const Transition& transition : component.transitions) {
        if (!is_in(report_.at(transition.origin), second_)) continue;
        any = true;
        if (!is_plain(component, transition) || !has_twin(component, transition)) return false;
        if (!is_alone(component, transition)) return false;
      }
    }
    return any;
  }

 private:
  bool has_twin(const Component& component, const Transition& transition) {
    return std::any_of(component.transitions.begin(), component.transitions.end(), [&](const Transition& other) {
      return other.from == transition.from && other.to == transition.to && other.guard == transition.guard &&
             is_plain(component, other) && is_in(report_.at(other.origin), first_);
    });
  }

  bool is_alone(const Component& component, const Transition& transition) {
    const Assignment mode{component.mode, ValueId(transition.from.index())};
    return std::none_of(component.transitions.begin(), component.transitions.end(), [&](const Transition& other) {
      if (other.from != transition.from || component.is_fault(other)) return false;
      if (other.to == transition.to && is_plain(component, other)) return false;
      return report_.analysis().questions().possible({&mode, 1},
                                                     automata::conjunction({transition.guard, other.guard}));
    });
  }

  PlantReport& report_;
  grammar::Span first_, second_;
};

}  // namespace

void report_duplicates(PlantReport& report) {
  const std::vector<grammar::Diagnostic> told = report.told();
  for (const grammar::Diagnostic& finding : told) {
    if (finding.code != grammar::Code::duplicate_transition || finding.notes.empty()) continue;
    if (!report.is_beside_plant(finding.span)) continue;
    if (!Duplicates(report, finding.notes.front().span, finding.span).has_no_effect()) continue;
    grammar::Diagnostic mended = finding;
    propose(mended, report.removals().of_statement(finding.span));
    if (!mended.fix.empty()) report.add(std::move(mended));
  }
}

}  // namespace rmpl::compiler
