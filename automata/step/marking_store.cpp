// Every location that tells something has a variable of its own in the theory, and is told under it.
// SPDX-License-Identifier: MIT
#include "automata/step/marking_store.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::automata {
namespace {

constexpr std::size_t is_marked = 1;  // position in the domain of a selector

/// The program's variables, and a selector for each location that tells something.
Variables with_selectors(const ModelProgram& program, std::vector<std::optional<VariableId>>& selectors) {
  Variables variables = program.variables;
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    auto& selector = selectors.emplace_back();
    if (program.locations[l].composite || program.locations[l].told.is_true()) continue;
    selector = variables.add({"location " + std::to_string(l + 1), {"unmarked", "marked"}});  // no surface name
  }
  return variables;
}

}  // namespace

Command command_from(const ModelProgram& program, std::span<const Assignment> assignments) {
  Command command;
  for (const CommandedVariable& control : program.controls) {
    const auto given = std::find_if(assignments.begin(), assignments.end(),
                                    [&](const Assignment& a) { return a.variable == control.variable; });
    command.push_back(given == assignments.end() ? control.idle : std::optional(given->value));
  }
  return command;
}

MarkingStore::MarkingStore(const ModelProgram& program, std::span<const Condition> conditions)
    : program_(program), theory_(with_selectors(program, selectors_), Theory::Upkeep::maintained) {
  for (const Interconnection& told : program.constraints) theory_.tell(told.constraint);
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    if (selectors_[l]) theory_.tell_if({*selectors_[l], ValueId(is_marked)}, program.locations[l].told);
  }
  for (const Condition& condition : conditions) {
    conditions_.emplace_back(theory_.encode(condition.constraint), condition.entailed);
  }
}

std::vector<Assignment> MarkingStore::told(const Marking& marking) const {
  std::vector<Assignment> result;
  for (const LocationId l : marking) {
    if (const auto& selector = selectors_[l.index()]) result.push_back({*selector, ValueId(is_marked)});
  }
  return result;
}

std::vector<Assignment> MarkingStore::told(const Marking& marking, const Command& command) const {
  std::vector<Assignment> result = told(marking);
  for (std::size_t c = 0; c < command.size(); ++c) {
    if (command[c]) result.push_back({program_.controls[c].variable, *command[c]});
  }
  return result;
}

bool MarkingStore::possible(const Marking& marking) { return theory_.consistent(told(marking)); }

bool MarkingStore::permits(const Marking& marking, const Command& command) {
  return theory_.consistent(told(marking, command));
}

bool MarkingStore::holds(std::size_t condition, const Marking& marking, const Command& command) {
  const auto& [formula, entailed] = conditions_[condition];
  return theory_.entails(told(marking, command), formula) == entailed;
}

double MarkingStore::factor(const Marking& marking, const Observation& observation) {
  const std::vector<Assignment> store = told(marking);
  std::vector<Assignment> seen = store;
  seen.insert(seen.end(), observation.begin(), observation.end());
  if (!theory_.consistent(seen)) return 0;
  double factor = 1;
  for (const Assignment& reading : observation) {
    if (!theory_.allows_other(store, reading)) continue;
    factor /= static_cast<double>(program_.variables[reading.variable].values.size());
  }
  return factor;
}

Marking MarkingStore::conflict(const Marking& marking, const Observation& observation) {
  std::vector<Assignment> seen = told(marking);
  if (theory_.consistent(seen)) {
    seen.insert(seen.end(), observation.begin(), observation.end());
    [[maybe_unused]] const bool consistent = theory_.consistent(seen);
    CHECK(!consistent);
  }
  const std::vector<Assignment> blamed = theory_.conflict();
  Marking result;
  for (const LocationId l : marking) {
    for (const Assignment& a : blamed) {
      if (selectors_[l.index()] == a.variable) result.push_back(l);
    }
  }
  return result;
}

std::vector<Assignment> MarkingStore::values(const Marking& marking) {
  const std::vector<Assignment> store = told(marking);
  std::vector<Assignment> model;
  if (theory_.consistent(store)) {
    for (std::size_t v = 0; v < program_.variables.size(); ++v) {
      model.push_back({VariableId(v), theory_.value(VariableId(v))});
    }
  }
  std::vector<Assignment> result;
  for (const Assignment& assignment : model) {
    if (!theory_.allows_other(store, assignment)) result.push_back(assignment);
  }
  return result;
}

}  // namespace rmpl::automata
