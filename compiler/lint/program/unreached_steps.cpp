// Steps that never start, as what comes before them in the sequence never ends.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/unreached_steps.hpp"

#include <string>
#include <variant>

#include "base/overloaded.hpp"
#include "compiler/lint/tree_walk.hpp"

namespace rmpl::compiler {

using grammar::Span;

namespace {

enum class Reached { unknown, no, yes };

/// Of all locations within a span.
Reached reached_within(const MarkedSpans& marked, Span span) {
  Reached reached = Reached::unknown;
  for (auto s = marked.lower_bound({span.file, span.begin, 0}); s != marked.end(); ++s) {
    if (s->first.file != span.file || s->first.begin >= span.end) break;
    if (s->second) return Reached::yes;
    reached = Reached::no;
  }
  return reached;
}

/// Why a step has no end.
std::string reason(const grammar::Step& step) {
  if (std::holds_alternative<grammar::Always>(step.node)) return "`always` never ends";
  if (std::holds_alternative<grammar::Whenever>(step.node)) return "`whenever` never ends";
  if (std::holds_alternative<grammar::Repeat>(step.node)) return "`repeat` never ends";
  return "this never ends";
}

void check(const grammar::Body& body, const MarkedSpans& marked, grammar::Diagnostics& found) {
  for (const grammar::Sequence& thread : body.threads) {
    for (std::size_t s = 1; s < thread.steps.size(); ++s) {
      const grammar::Step& step = thread.steps[s];
      const grammar::Step& before = thread.steps[s - 1];
      if (reached_within(marked, step.span) != Reached::no) continue;
      if (reached_within(marked, before.span) != Reached::yes) continue;
      const Span rest = join(step.span, thread.steps.back().span);
      auto& finding =
          add_finding(found, grammar::Code::step_never_reached, rest,
                      s + 1 == thread.steps.size() ? "this step is never reached" : "these steps are never reached");
      finding.notes.push_back({before.span, reason(before)});
      finding.suggestion = "to run the steps in parallel, write `,` instead of `;`";
      break;
    }
  }
}

}  // namespace

void report_unreached_steps(const LintInput& input, const MarkedSpans& marked, grammar::Diagnostics& found) {
  const base::Overloaded visit{[&](const grammar::Body& body) { check(body, marked, found); },
                               [](const grammar::Step&) {}};
  for_each_definition(input, [&](const grammar::Definition& definition) { for_each_step(definition.body, visit); });
}

}  // namespace rmpl::compiler
