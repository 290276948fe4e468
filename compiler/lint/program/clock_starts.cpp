// Clocks that are started where a path may have started them, which changes nothing.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/program/bound_programs.hpp"
#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/program/reachable_locations.hpp"

namespace rmpl::compiler {

using automata::ClockId;
using automata::Location;
using automata::LocationId;

namespace {

/// Where a run can get to behind a location, without entering what has the clock as its own.
class Onward {
 public:
  Onward(const automata::Program& program, const ReachableLocations& reach, ClockId clock)
      : program_(program), reach_(reach), clock_(clock), seen_(program.locations.size(), false) {}

  /// The locations that can be marked after this one, this one only where a run leads back to it.
  const std::vector<bool>& behind(LocationId location) {
    leave(location.index());
    return followed();
  }
  /// The same after what a location that repeats for ever starts each time. What the location is in ends once, and it
  /// with that.
  const std::vector<bool>& started_by(LocationId repeating) {
    for (auto in = program_.locations[repeating.index()].parent; in; in = program_.locations[in->index()].parent) {
      left_.insert(in->index());
    }
    for (const automata::Arc& arc : program_.locations[repeating.index()].arcs) {
      if (arc.target != repeating) enter(arc.target.index());
    }
    return followed();
  }

 private:
  const std::vector<bool>& followed() {
    while (!pending_.empty()) {
      const std::size_t next = pending_.back();
      pending_.pop_back();
      leave(next);
    }
    return seen_;
  }
  void leave(std::size_t l) {
    for (const automata::Arc& arc : program_.locations[l].arcs) enter(arc.target.index());
    // Its end may be the end of what it is in.
    const auto parent = program_.locations[l].parent;
    if (parent && !left_.count(parent->index()) && reach_.may_end(*parent)) {
      left_.insert(parent->index());
      leave(parent->index());
    }
  }
  void enter(std::size_t l) {
    const Location& location = program_.locations[l];
    const auto& own = location.own_clocks;
    if (seen_[l] || std::find(own.begin(), own.end(), clock_) != own.end()) return;
    seen_[l] = true;
    pending_.push_back(l);
    if (!location.composite) return;
    for (std::size_t child = l + 1; child < program_.locations.size(); ++child) {
      const auto& parent = program_.locations[child].parent;
      if (!parent || parent->index() < l) break;
      if (parent->index() == l && program_.locations[child].start) enter(child);
    }
  }

  const automata::Program& program_;
  const ReachableLocations& reach_;
  const ClockId clock_;
  std::vector<bool> seen_;
  std::set<std::size_t> left_;
  std::vector<std::size_t> pending_;
};

void report(const LintInput& input, const BoundProgram& bound, LocationId first, LocationId second,
            std::set<grammar::Span>& told, grammar::Diagnostics& found) {
  const grammar::Span span = span_of(input, bound, second);
  const grammar::Span before = span_of(input, bound, first);
  if (!told.insert(span).second) return;
  const Location& location = bound.program.locations[second.index()];
  const std::string& name = bound.program.clocks[location.clock_start->index()];
  const std::string written = name.substr(0, name.find('@'));
  auto& finding = add_finding(
      found, grammar::Code::clock_started_twice, span,
      "clock " + backquoted(written) + " may run already: then this changes nothing, and waits do not start anew");
  if (before == span) {
    finding.suggestion =
        "declare it at the start of the definition, `clock " + written + ";`: then each call has a clock of its own";
  } else {
    finding.notes.push_back({before, "it may have been started here"});
    finding.suggestion = "take another clock for the second wait, or put the wait into a definition with `clock " +
                         written + ";` at its start";
  }
}

/// Whether a location stays marked for ever, as `always` and `whenever` do.
bool repeats(const Location& location, LocationId id) {
  return std::any_of(location.arcs.begin(), location.arcs.end(),
                     [&](const automata::Arc& arc) { return arc.target == id && arc.guard.is_trivial(); });
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
