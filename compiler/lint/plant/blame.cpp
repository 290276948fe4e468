// Contradictions, made minimal.
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/blame.hpp"

#include <algorithm>
#include <string>

#include "compiler/lint/plant/exclusions.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Formula;
using automata::ValueId;
using automata::VariableId;

namespace {

constexpr ValueId told(1);

/// The plant's variables, then one for each interconnection, then one for each mode.
automata::Variables with_switches(const automata::Plant& plant) {
  automata::Variables result = plant.variables;
  for (std::size_t q = 0; q < plant.interconnections.size(); ++q) {
    result.add({"interconnection " + std::to_string(q) + " is told", {"no", "yes"}});
  }
  add_exclusions(result, plant);
  return result;
}

}  // namespace

Blame::Blame(const automata::Plant& plant, const ModeSets& modes) : plant_(plant), theory_(with_switches(plant)) {
  std::size_t next = plant.variables.size();
  for (const automata::Interconnection& q : plant.interconnections) {
    told_.push_back({VariableId(next++), told});
    theory_.tell_if(told_.back(), q.constraint);
  }
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const automata::Component& component = plant.components[c];
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const Assignment mode{component.mode, ValueId(m)};
      if (!component.modes[m].constraint.is_true()) theory_.tell_if(mode, component.modes[m].constraint);
      const Assignment exclusion{VariableId(next++), told};
      theory_.tell_if(exclusion, negation(is(component.mode, ValueId(m))));
      if (modes[c][m]) continue;
      excluded_.push_back(exclusion);
      never_.push_back(mode);
    }
  }
}

Contradiction Blame::of(std::span<const Assignment> assumptions, const Formula& formula) {
  std::vector<Assignment> all(assumptions.begin(), assumptions.end());
  all.insert(all.end(), told_.begin(), told_.end());
  for (std::size_t i = 0; i < excluded_.size(); ++i) {
    const bool is_assumed = std::any_of(assumptions.begin(), assumptions.end(),
                                        [&](const Assignment& a) { return a.variable == never_[i].variable; });
    if (!is_assumed) all.push_back(excluded_[i]);
  }
  Contradiction result;
  const automata::Theory::Handle handle = theory_.encode(formula);
  if (theory_.allows(all, handle)) return result;
  for (const Assignment& a : theory_.minimal_conflict(theory_.conflict(), handle)) {
    if (a.variable.index() < plant_.variables.size()) {
      result.assumed.push_back(a);
    } else if (a.variable.index() < plant_.variables.size() + told_.size()) {
      result.interconnections.push_back(a.variable.index() - plant_.variables.size());
    } else {
      const auto at = std::find(excluded_.begin(), excluded_.end(), a);
      result.never.push_back(never_[static_cast<std::size_t>(at - excluded_.begin())]);
    }
  }
  return result;
}

}  // namespace rmpl::compiler
