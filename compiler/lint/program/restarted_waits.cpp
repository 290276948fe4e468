// Waits that `whenever` or `always` starts anew in cycle after cycle, while they last.
//
// What the construct starts is looked at in the automaton, through calls: each wait in it is a location that keeps
// itself marked. The state that matters is one in which the condition holds and the wait does too.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/overloaded.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/program/bound_programs.hpp"
#include "compiler/lint/program/onward.hpp"
#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/program/possibilities.hpp"
#include "compiler/lint/tree_walk.hpp"

namespace rmpl::compiler {

using automata::ClockId;
using automata::Condition;
using automata::Formula;
using automata::Location;
using automata::LocationId;
using grammar::Span;

namespace {

/// The wait of a `when` location: what it waits for; null for other locations.
const Formula* wait_of(const Location& location, LocationId id) {
  for (const automata::Arc& arc : location.arcs) {
    if (arc.target == id && !arc.guard.entailed) return &arc.guard.constraint;
  }
  return nullptr;
}

void collect_clocks(const Formula& formula, std::set<ClockId>& clocks) {
  if (formula.kind == Formula::Kind::clock && formula.bound > automata::Ticks{0}) clocks.insert(formula.clock);
  for (const Formula& operand : formula.operands) collect_clocks(operand, clocks);
}

/// The `whenever` or `always` at a place, as it is written; null where the program came compiled.
const grammar::Step* construct_at(const LintInput& input, Span span) {
  const grammar::Step* found = nullptr;
  const base::Overloaded visit{[](const grammar::Body&) {},
                               [&](const grammar::Step& step) {
                                 const bool starts_again = std::holds_alternative<grammar::Whenever>(step.node) ||
                                                           std::holds_alternative<grammar::Always>(step.node);
                                 if (step.span == span && starts_again) found = &step;
                               }};
  for_each_definition(input, [&](const grammar::Definition& definition) { for_each_step(definition.body, visit); });
  return found;
}

class RestartedWaits {
 public:
  RestartedWaits(const LintInput& input, const BoundProgram& bound, std::set<Span>& told, grammar::Diagnostics& found)
      : input_(input),
        bound_(bound),
        told_(told),
        found_(found),
        reach_(flow_of(bound.program,
                       [](const Condition& condition) -> Freedom {
                         return {true, !condition.is_trivial()};
                       })),
        possibilities_(bound.program.variables, bound.plant) {}

  void run() {
    for (std::size_t l = 0; l < locations().size(); ++l) {
      if (repeats(locations()[l], LocationId(l)) && reach_.reached(LocationId(l))) look_at(LocationId(l));
    }
  }

 private:
  /// The first wait that reads a clock which starts anew, or else the first wait.
  struct Restart {
    LocationId wait;
    std::optional<ClockId> clock;
  };

  [[nodiscard]] const std::vector<Location>& locations() const { return bound_.program.locations; }

  /// What has to hold for the construct to start again: always, that is `true`.
  [[nodiscard]] Formula condition_of(LocationId repeating) const {
    for (const automata::Arc& arc : locations()[repeating.index()].arcs) {
      if (arc.target != repeating) return arc.guard.constraint;
    }
    return automata::constant(true);
  }

  void look_at(LocationId repeating) {
    Onward onward(bound_.program, reach_);
    const std::vector<bool>& inside = onward.started_by(repeating);
    std::set<ClockId> own;
    for (std::size_t l = 0; l < inside.size(); ++l) {
      if (inside[l]) own.insert(locations()[l].own_clocks.begin(), locations()[l].own_clocks.end());
    }
    const Formula condition = condition_of(repeating);
    std::optional<Restart> restart;
    for (std::size_t l = 0; l < inside.size(); ++l) {
      const Formula* const wait = inside[l] ? wait_of(locations()[l], LocationId(l)) : nullptr;
      if (wait == nullptr || !can_last(condition, *wait)) continue;
      std::set<ClockId> read;
      collect_clocks(*wait, read);
      const auto clock = std::find_if(read.begin(), read.end(), [&](ClockId c) { return own.contains(c); });
      if (clock != read.end()) {
        restart = {LocationId(l), *clock};
        break;
      }
      if (!restart) restart = {LocationId(l), std::nullopt};
    }
    if (restart) report(repeating, *restart);
  }

  /// Whether a state can have the condition while the wait goes on: then the construct starts again beside it.
  bool can_last(const Formula& condition, const Formula& wait) {
    return possibilities_.can_hold(automata::conjunction({condition, automata::negation(wait)}));
  }

  [[nodiscard]] std::string text_of(const Formula& formula) const {
    return backquoted(automata::to_text(formula, bound_.program.variables, bound_.program.clocks));
  }

  void report(LocationId repeating, const Restart& restart) {
    const Span span = span_of(input_, bound_, repeating);
    if (!told_.insert(span).second) return;
    const Formula condition = condition_of(repeating);
    const Formula& wait = *wait_of(locations()[restart.wait.index()], restart.wait);
    const std::string when =
        condition.is_true() ? "in every cycle" : "in every cycle in which " + text_of(condition) + " holds";
    std::string text = "this starts its step again " + when;
    if (restart.clock) {
      const std::string& name = bound_.program.clocks[restart.clock->index()];
      const std::string clock = backquoted(name.substr(0, name.find('@')));
      text += ", and restarts clock " + clock + ": " + (condition.is_true() ? "" : "meanwhile ") + clock +
              " never exceeds one cycle";
    } else {
      text += ", in parallel to the wait that is still running";
    }
    auto& finding = add_finding(found_, grammar::Code::restarted_wait, span, text);
    if (!restart.clock) finding.severity = grammar::Severity::note;
    finding.notes.push_back({span_of(input_, bound_, restart.wait), "the step waits here for " + text_of(wait)});
    suggest(finding, span);
  }

  /// `repeat` waits for the end of what it has started.
  void suggest(grammar::Diagnostic& finding, Span span) const {
    const grammar::Step* const step = construct_at(input_, span);
    if (step == nullptr) return;
    if (std::holds_alternative<grammar::Always>(step->node)) {
      finding.suggestion = "to run the step to its end each time, write `repeat` instead of `always`";
      return;
    }
    constexpr std::string_view keyword = "whenever";
    finding.suggestion = "to run the step to its end each time, write `repeat when` instead of `whenever`";
    finding.fix = {{{span.file, span.begin, span.begin + static_cast<std::uint32_t>(keyword.size())}, "repeat when"}};
  }

  const LintInput& input_;
  const BoundProgram& bound_;
  std::set<Span>& told_;
  grammar::Diagnostics& found_;
  ReachableLocations reach_;
  Possibilities possibilities_;
};

}  // namespace

void lint_restarted_waits(const LintInput& input, grammar::Diagnostics& found) {
  std::set<Span> told;
  for (const BoundProgram& bound : bound_programs(input)) RestartedWaits(input, bound, told, found).run();
}

}  // namespace rmpl::compiler
