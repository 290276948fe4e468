// Scenarios: rules that never fire, and times that the cycle cannot tell apart.
// SPDX-License-Identifier: MIT
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/program/bound_programs.hpp"
#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/program/possibilities.hpp"
#include "compiler/lint/program/reachable_modes.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::Scenario;
using automata::Ticks;
using grammar::Code;

namespace {

std::string seconds(Ticks time) { return automata::format_seconds(time) + " s"; }

/// Why a rule never fires; empty where it may.
std::string obstacle(const automata::Rule& rule, const Scenario& scenario, Possibilities& possible,
                     const ReachableModes& reach) {
  if (possible.consistent() && !possible.can_hold(rule.trigger)) return "its condition can never hold";
  if (rule.stream == automata::Rule::Stream::estimate &&
      !possible.can_hold(automata::conjunction({rule.trigger, reach.formula()}))) {
    return "its condition needs modes that the plant never enters";
  }
  // So many cycles that they cannot be counted in ticks are behind any end.
  const std::uint64_t most = static_cast<std::uint64_t>(scenario.duration.count / scenario.cycle.count);
  const bool late = rule.delay ? *rule.delay > scenario.duration : rule.delay_cycles > most;
  return late ? "the scenario ends after " + seconds(scenario.duration) + ", before the delay of the rule" : "";
}

/// Collects bounds of clocks that are above 0 and below the cycle.
void collect_fine(const Formula& formula, Ticks cycle, std::vector<Ticks>& fine) {
  if (formula.kind == Formula::Kind::clock && formula.bound > Ticks{0} && formula.bound < cycle) {
    fine.push_back(formula.bound);
  }
  for (const Formula& operand : formula.operands) collect_fine(operand, cycle, fine);
}

class FineTimes {
 public:
  FineTimes(const LintInput& input, grammar::Diagnostics& found) : input_(input), found_(found) {}

  void scenario(const Scenario& scenario) {
    for (const automata::SensorOverride& o : scenario.overrides) {
      check(o.duration, scenario.cycle, o.origin, "the reading may end before the executive reads it");
    }
    for (const automata::GivenCommand& c : scenario.commands) {
      check(c.duration, scenario.cycle, c.origin, "the command may end before the next cycle begins");
    }
    for (const automata::Rule& rule : scenario.rules) {
      check(rule.duration, scenario.cycle, rule.origin, "the reading may end before the executive reads it");
      if (rule.delay)
        check(*rule.delay, scenario.cycle, rule.origin,
              "the rule takes effect in the next cycle, as without the delay");
    }
    for (const automata::Expectation& e : scenario.expectations) {
      if (e.within) check(*e.within, scenario.cycle, e.origin, "the expectation is met only if it holds at once");
    }
  }

  /// A mode that is over within a cycle is none that the executive sees, which may be what it is there for.
  void plant(const automata::Plant& plant, Ticks cycle) {
    for (const automata::Component& component : plant.components) {
      for (const automata::Transition& transition : component.transitions) {
        const grammar::Span span = input_.places.at(transition.origin);
        if (!transition.timing || transition.timing->upper == Ticks{0} || transition.timing->upper >= cycle) continue;
        if (!input_.places.has(transition.origin) || !told_.insert(span).second) continue;
        report(transition.timing->upper, cycle, span, "the mode may end before the executive reads the plant again")
            .severity = grammar::Severity::note;
      }
    }
  }

  void program(const BoundProgram& bound) {
    for (const PlacedCondition& condition : bound.places.conditions) {
      std::vector<Ticks> fine;
      collect_fine(condition.formula, bound.cycle, fine);
      if (!fine.empty())
        report(fine.front(), bound.cycle, condition.span, "the program first reads a clock one cycle after its start");
    }
  }

 private:
  void check(Ticks time, Ticks cycle, const automata::Origin& origin, const char* consequence) {
    if (time > Ticks{0} && time < cycle) report(time, cycle, input_.places.at(origin), consequence);
  }
  grammar::Diagnostic& report(Ticks time, Ticks cycle, grammar::Span span, const char* consequence) {
    return add_finding(found_, Code::finer_than_cycle, span,
                       seconds(time) + " is less than the cycle, " + seconds(cycle) + ": " + consequence);
  }

  const LintInput& input_;
  grammar::Diagnostics& found_;
  std::set<grammar::Span> told_;  ///< transitions, which instances of a type share
};

}  // namespace

void lint_rules(const LintInput& input, grammar::Diagnostics& found) {
  std::map<std::size_t, Possibilities> by_plant;
  for (const Scenario& scenario : input.document.scenarios) {
    if (scenario.rules.empty()) continue;
    const automata::Plant& plant = input.document.plants[scenario.plant];
    Possibilities& possible = by_plant.try_emplace(scenario.plant, plant.variables, &plant).first->second;
    const ReachableModes reach(plant, added_modes(scenario, plant));
    for (const automata::Rule& rule : scenario.rules) {
      const std::string why = obstacle(rule, scenario, possible, reach);
      if (why.empty()) continue;
      add_finding(found, Code::rule_never_fires, input.places.at(rule.origin), "the rule never takes effect: " + why);
    }
  }
}

void lint_fine_times(const LintInput& input, grammar::Diagnostics& found) {
  FineTimes times(input, found);
  for (const Scenario& scenario : input.document.scenarios) {
    times.scenario(scenario);
    times.plant(input.document.plants[scenario.plant], scenario.cycle);
  }
  for (const BoundProgram& bound : bound_programs(input)) times.program(bound);
}

}  // namespace rmpl::compiler
