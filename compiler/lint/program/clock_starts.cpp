// Clocks that are started where a path may have started them, which changes nothing.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/program/bound_programs.hpp"
#include "compiler/lint/program/onward.hpp"
#include "compiler/lint/program/passes.hpp"

namespace rmpl::compiler {

using automata::Location;
using automata::LocationId;

namespace {

void report(const LintInput& input, const BoundProgram& bound, LocationId first, LocationId second,
            std::set<grammar::Span>& told, grammar::Diagnostics& found) {
  const grammar::Span span = span_of(input, bound, second);
  const grammar::Span before = span_of(input, bound, first);
  if (!told.insert(span).second) return;
  const Location& location = bound.program.locations[second.index()];
  const std::string& name = bound.program.clocks[location.clock_start->index()];
  const std::string written = name.substr(0, name.find('@'));
  auto& finding =
      add_finding(found, grammar::Code::clock_started_twice, span,
                  "clock " + backquoted(written) +
                      " may be running already: this start then has no effect, and a later wait may end at once");
  if (before == span) {
    finding.suggestion = "declare it at the start of a definition, `clock " + written +
                         ";`, so that each call has its own clock. Call that definition from a recursive definition, "
                         "not from `whenever`";
  } else {
    finding.notes.push_back({before, "the clock may have been started here"});
    finding.suggestion = "use another clock for the second wait, or put the wait into a definition with `clock " +
                         written + ";` at its start";
  }
}

void check(const LintInput& input, const BoundProgram& bound, std::set<grammar::Span>& told,
           grammar::Diagnostics& found) {
  const auto& locations = bound.program.locations;
  std::vector<LocationId> starts;
  std::vector<LocationId> repeating;
  for (std::size_t l = 0; l < locations.size(); ++l) {
    if (locations[l].clock_start) starts.emplace_back(l);
    if (repeats(locations[l], LocationId(l))) repeating.emplace_back(l);
  }
  if (starts.empty()) return;
  const ReachableLocations reach(flow_of(bound.program, [](const automata::Condition& condition) -> Freedom {
    return {true, !condition.is_trivial()};
  }));
  const auto clock_of = [&](LocationId start) { return *locations[start.index()].clock_start; };
  for (const LocationId first : starts) {
    Onward onward(bound.program, reach, clock_of(first));
    const std::vector<bool>& behind = onward.behind(first);
    for (const LocationId second : starts) {
      if (behind[second.index()] && clock_of(second) == clock_of(first)) {
        report(input, bound, first, second, told, found);
      }
    }
    for (const LocationId loop : repeating) {
      Onward again(bound.program, reach, clock_of(first));
      if (again.started_by(loop)[first.index()]) report(input, bound, first, first, told, found);
    }
  }
}

}  // namespace

void lint_clock_starts(const LintInput& input, grammar::Diagnostics& found) {
  std::set<grammar::Span> told;
  for (const BoundProgram& bound : bound_programs(input)) check(input, bound, told, found);
}

}  // namespace rmpl::compiler
