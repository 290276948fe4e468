// What faults do, next and in the end.
// SPDX-License-Identifier: MIT
#include "verifier/safety/fmea.hpp"

#include <algorithm>

#include "automata/controls.hpp"
#include "verifier/closed_loop/each_fault.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::Modes;
using automata::Plant;
using automata::ValueId;
using automata::VariableId;

namespace {

constexpr double seconds_per_hour = 3600;

/// What the fault by itself changes, all other modes being as they were before it.
void add_effects(automata::PlantStep& step, const Witness& happens, FailureMode& row) {
  const Plant& plant = step.plant();
  if (happens.events.size() < 2) return;
  std::size_t at = 1;
  while (at + 1 < happens.events.size() && happens.events[at].modes[row.fault.component.index()] != row.fault.to) ++at;
  const Modes before = happens.events[at - 1].modes;
  Modes after = before;
  after[row.fault.component.index()] = row.fault.to;
  if (!step.possible(after)) after = happens.events[at].modes;
  for (std::size_t v = 0; v < plant.variables.size(); ++v) {
    const VariableId variable(v);
    if (plant.component_of(variable) || automata::is_control(plant, variable)) continue;
    const EffectChange change{variable, implied(step, before, variable), implied(step, after, variable)};
    if (change.before == change.after) continue;
    row.next.push_back(change);
    const bool observed =
        std::find(plant.observables.begin(), plant.observables.end(), variable) != plant.observables.end();
    if (observed && change.before && change.after) row.detected.push_back(change);
  }
}

/// The first command that is sent after the fault on a run that has it.
std::vector<Assignment> response_on(const Plant& plant, const Witness& run, const FaultStep& fault) {
  bool happened = false;
  for (const Event& event : run.events) {
    if (happened) {
      auto sent = automata::commanded(plant, event.action);
      if (!sent.empty()) return sent;
    }
    happened = happened || event.modes[fault.component.index()] == fault.to;
  }
  return {};
}

void add_weight(const Plant& plant, FailureMode& row) {
  for (const automata::Transition& t : plant[row.fault.component].transitions) {
    if (t.from != row.fault.from || t.to != row.fault.to) continue;
    if (t.weight.kind == automata::Weight::Kind::rate)
      row.rate = row.rate.value_or(0) + t.weight.value * seconds_per_hour;
    if (t.weight.kind == automata::Weight::Kind::probability) {
      row.per_step = std::max(row.per_step.value_or(0), t.weight.value);
    }
  }
}

/// Whether the fault alone violates it; nothing where the table of faults does not tell that.
std::optional<bool> violates(const FaultOutcome& outcome, ProgramProperty::Kind kind) {
  using Kind = ProgramProperty::Kind;
  const bool stops = outcome.stops.has_value();
  switch (kind) {
    case Kind::never:
    case Kind::eventually:
    case Kind::response:
    case Kind::finally:
      return outcome.lost.has_value();
    case Kind::no_plan:
      return outcome.no_plan.has_value();
    case Kind::endless_wait:
      return outcome.waits.has_value();
    case Kind::termination:
      return outcome.waits || outcome.goes_on || stops;
    case Kind::stuck:
      return stops;
    case Kind::goal_conflict:
    case Kind::undone:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ValueId> implied(automata::PlantStep& step, const Modes& modes, VariableId variable) {
  const std::vector<Assignment> store = automata::assignments_of(step.plant(), modes);
  automata::Theory& theory = step.theory();
  if (!theory.consistent(store)) return std::nullopt;
  const std::size_t values = step.plant().variables[variable].values.size();
  std::optional<ValueId> found;
  for (std::size_t v = 0; v < values; ++v) {
    std::vector<Assignment> with = store;
    with.push_back({variable, ValueId(v)});
    if (!theory.consistent(with)) continue;
    if (found) return std::nullopt;
    found = ValueId(v);
  }
  return found;
}

FailureModes failure_modes(const automata::Program& program, automata::PlantStep& step,
                           const std::vector<NamedProperty>& mission, const CheckOptions& options, const Limits& limits,
                           const std::vector<automata::ComponentId>& components) {
  std::vector<Property> all;
  all.reserve(mission.size());
  for (const NamedProperty& one : mission) all.emplace_back(one.property);
  const FaultTable table = check_each_fault(program, step, all, options, limits, components);
  FailureModes result;
  result.limit = table.limit;
  result.progress = table.progress;
  FaultOutcome without;
  for (const FaultOutcome& outcome : table.rows) {
    if (!outcome.fault) {
      if (outcome.success) result.succeeds = outcome.success->events.back().time;
      without = outcome;
      continue;
    }
    FailureMode& row = result.rows.emplace_back();
    row.fault = *outcome.fault;
    row.decided = outcome.decided;
    row.end = outcomes_of(outcome);
    row.fails = outcome.fails();
    add_weight(step.plant(), row);
    if (!outcome.happens) {
      // By itself: as a second fault it may.
      const bool follows = step.plant()[row.fault.component].modes[row.fault.from.index()].fault;
      if (outcome.decided && follows) row.end = {"only after another fault"};
      continue;
    }
    row.earliest = outcome.happens->events.back().time;
    if (outcome.decided) {
      using Kind = ProgramProperty::Kind;
      for (const auto& [name, kind] : {std::pair{"terminates", Kind::termination}, {"never no-plan", Kind::no_plan}}) {
        const bool violated = violates(outcome, kind).value();
        row.checks.push_back({name, violated, violated && violates(without, kind).value()});
      }
    }
    add_effects(step, *outcome.happens, row);
    for (const auto* run : {&outcome.success, &outcome.lost, &outcome.waits, &outcome.goes_on}) {
      if (!*run || !row.response.empty()) continue;
      row.response = response_on(step.plant(), **run, row.fault);
    }
  }
  // Which property it is, each by itself.
  for (const NamedProperty& one : mission) {
    if (result.limit) break;
    const FaultTable own =
        check_each_fault(program, step, {one.property}, options, remaining(limits, result.progress), components);
    result.limit = own.limit;
    std::size_t r = 0;
    bool anyway = false;
    for (const FaultOutcome& outcome : own.rows) {
      const std::optional<bool> violated = violates(outcome, one.property.kind);
      if (!outcome.fault) {
        anyway = violated.value_or(false);
        continue;
      }
      FailureMode& row = result.rows[r++];
      row.decided = row.decided && outcome.decided;
      if (violated && outcome.happens && outcome.decided)
        row.checks.push_back({one.name, *violated, *violated && anyway});
      if (!violated.value_or(false) || anyway) continue;
      row.violated.push_back(one.name);
      if (one.severity && (!row.severity || *one.severity < *row.severity)) row.severity = one.severity;
    }
    result.progress.states += own.progress.states;
    result.progress.seconds += own.progress.seconds;
  }
  return result;
}

}  // namespace rmpl::verifier
