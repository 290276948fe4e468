// Goals of two threads that ask for different modes of one component in one cycle.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "automata/assignment_text.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/program/bound_programs.hpp"
#include "compiler/lint/program/goal_threads.hpp"
#include "compiler/lint/program/marking_search.hpp"
#include "compiler/lint/program/meeting_goals.hpp"
#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/program/reachable_modes.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using grammar::Span;

namespace {

/// When the goals meet: `in cycle 3, where … holds in cycle 1`. Clocks run on by any amount in a cycle there, so with
/// clocks it may be later.
std::string meeting(const GoalClash& clash, bool clocks) {
  std::string text =
      clash.cycle == 1 ? "both are asserted in the first cycle"
                       : "both are asserted in cycle " + std::to_string(clash.cycle) +
                             (clocks ? " at the earliest, or later if a clock bound requires it" : " at the earliest");
  const char* separator = ": where ";
  for (std::size_t cycle = 0; cycle < clash.history.size(); ++cycle) {
    if (clash.history[cycle].empty()) continue;
    text += separator + clash.history[cycle] + " at the end of cycle " + std::to_string(cycle + 1);
    separator = "; ";
  }
  return text;
}

void report(const LintInput& input, const BoundProgram& bound, const GoalClash& clash,
            std::set<std::pair<Span, Span>>& told, grammar::Diagnostics& found) {
  Span first = span_of(input, bound, clash.conflict.first);
  Span second = span_of(input, bound, clash.conflict.second);
  auto asked = clash.conflict.asserted;
  auto other = clash.conflict.contradicted;
  if (second < first) {
    std::swap(first, second);
    std::swap(asked, other);
  }
  if (!told.insert({first, second}).second) return;
  const automata::Variables& variables = bound.program.variables;
  const auto text = [&](const Assignment& goal) { return backquoted(to_text(variables, goal)); };
  auto& finding = add_finding(found, grammar::Code::contradicting_goals, second,
                              text(asked) + (clash.certain ? " is" : " can be") + " asserted together with " +
                                  text(other) + ": in such a cycle the executive sends no command");
  if (clash.certain && clash.cycle > 1) finding.message += "; one of the two goals is never asserted without the other";
  // Where it takes a plant that does this and not that, it may be one that nobody has.
  if (!clash.certain) finding.severity = grammar::Severity::note;
  finding.notes.push_back({first, text(other) + " is asserted here"});
  finding.suggestion = meeting(clash, !bound.program.clocks.empty());
}

}  // namespace

void lint_contradicting_goals(const LintInput& input, grammar::Diagnostics& found) {
  std::set<std::pair<Span, Span>> told;
  for (const BoundProgram& bound : bound_programs(input)) {
    const auto components = components_of_meeting_goals(bound.program);
    if (components.empty()) continue;
    // All components together go no further than one alone would be let go in a small program.
    constexpr std::size_t work = 20'000'000;  // a step looks at all locations
    SearchLimits limits;
    limits.states = std::max<std::size_t>(200, limits.states / components.size());
    limits.steps = std::min(limits.steps, work / bound.program.locations.size()) / components.size();
    std::vector<automata::Formula> stages;
    if (bound.plant != nullptr) stages = ReachableModes::by_cycle(*bound.plant, bound.also);
    FreeConditions conditions(bound.program, bound.plant, std::move(stages));
    for (const automata::VariableId component : components) {
      const auto relevant = goal_threads(bound.program, component);
      for (const GoalClash& clash : find_goal_clashes(bound.program, conditions, relevant, limits)) {
        if (clash.conflict.asserted.variable == component) report(input, bound, clash, told, found);
      }
    }
  }
}

}  // namespace rmpl::compiler
