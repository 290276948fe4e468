// Steps of control programs that never start.
// SPDX-License-Identifier: MIT
#include <utility>

#include "compiler/lint/program/bound_programs.hpp"
#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/program/possibilities.hpp"
#include "compiler/lint/program/reachable_locations.hpp"
#include "compiler/lint/program/unreached_steps.hpp"

namespace rmpl::compiler {

using automata::Condition;

namespace {

void add_locations(const LintInput& input, const BoundProgram& bound, MarkedSpans& marked) {
  Possibilities possible(bound.program.variables, bound.plant);
  if (!possible.consistent()) return;
  const FreedomOf freedom = [&](const Condition& condition) -> Freedom {
    if (condition.is_trivial()) return {true, false};
    Freedom free{possible.can_hold(condition.constraint), possible.can_fail(condition.constraint)};
    if (!condition.entailed) std::swap(free.may_hold, free.may_fail);
    return free;
  };
  const ReachableLocations reach(flow_of(bound.program, freedom));
  for (std::size_t l = 0; l < bound.program.locations.size(); ++l) {
    const automata::LocationId location(l);
    bool& reached = marked[span_of(input, bound, location)];
    reached = reached || reach.reached(location);
  }
}

}  // namespace

void lint_unreachable_steps(const LintInput& input, grammar::Diagnostics& found) {
  MarkedSpans marked;
  for (const BoundProgram& bound : bound_programs(input)) add_locations(input, bound, marked);
  report_unreached_steps(input, marked, found);
}

}  // namespace rmpl::compiler
