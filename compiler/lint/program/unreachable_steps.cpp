// Steps that never start, as what comes before them in the sequence never ends.
// SPDX-License-Identifier: MIT
#include <map>
#include <string>
#include <utility>

#include "base/overloaded.hpp"
#include "compiler/lint/program/bound_programs.hpp"
#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/program/possibilities.hpp"
#include "compiler/lint/program/reachable_locations.hpp"
#include "compiler/lint/tree_walk.hpp"

namespace rmpl::compiler {

using automata::Condition;
using grammar::Span;

namespace {

/// Where locations stand in the text, and whether one that stands there may be marked.
using Starts = std::map<Span, bool>;

void add_locations(const LintInput& input, const BoundProgram& bound, Starts& starts) {
  Possibilities possible(bound.program.variables, bound.plant);
  if (!possible.consistent()) return;
  const FreedomOf freedom = [&](const Condition& condition) -> Freedom {
    if (condition.is_trivial()) return {true, false};
    Freedom free{possible.can_hold(condition.constraint), possible.can_fail(condition.constraint)};
    if (!condition.entailed) std::swap(free.may_hold, free.may_fail);
    return free;
  };
  const ReachableLocations reach(bound.program, freedom);
  for (std::size_t l = 0; l < bound.program.locations.size(); ++l) {
    const automata::LocationId location(l);
    bool& reached = starts[span_of(input, bound, location)];
    reached = reached || reach.reached(location);
  }
}

enum class Reached { unknown, no, yes };

/// Of all locations within a span.
Reached reached_within(const Starts& starts, Span span) {
  Reached reached = Reached::unknown;
  for (auto s = starts.lower_bound({span.file, span.begin, 0}); s != starts.end(); ++s) {
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
  return "this never ends";
}

void check(const grammar::Body& body, const Starts& starts, grammar::Diagnostics& found) {
  for (const grammar::Sequence& thread : body.threads) {
    for (std::size_t s = 1; s < thread.steps.size(); ++s) {
      const grammar::Step& step = thread.steps[s];
      const grammar::Step& before = thread.steps[s - 1];
      if (reached_within(starts, step.span) != Reached::no) continue;
      if (reached_within(starts, before.span) != Reached::yes) continue;
      const Span rest = join(step.span, thread.steps.back().span);
      auto& finding =
          add_finding(found, grammar::Code::step_never_reached, rest,
                      s + 1 == thread.steps.size() ? "this step is never reached" : "these steps are never reached");
      finding.notes.push_back({before.span, reason(before)});
      finding.suggestion = "if it is meant to run beside, put `,` in the place of `;`";
      break;
    }
  }
}

}  // namespace

void lint_unreachable_steps(const LintInput& input, grammar::Diagnostics& found) {
  Starts starts;
  for (const BoundProgram& bound : bound_programs(input)) add_locations(input, bound, starts);
  const base::Overloaded visit{[&](const grammar::Body& body) { check(body, starts, found); },
                               [](const grammar::Step&) {}};
  for_each_definition(input, [&](const grammar::Definition& definition) { for_each_step(definition.body, visit); });
}

}  // namespace rmpl::compiler
