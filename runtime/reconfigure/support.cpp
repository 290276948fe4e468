// Supports by counterexample-guided refinement over the constraint store.
// SPDX-License-Identifier: MIT
#include "runtime/reconfigure/support.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <tuple>

#include "automata/step/model.hpp"

namespace runtime {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::Formula;
using automata::Plant;
using automata::Theory;
using automata::TransitionId;
using automata::ValueId;
using automata::VariableId;

namespace {

constexpr std::size_t yes = 1;

/// The plant with a variable for each transition; `?` keeps the names apart from those of models.
Plant with_questions(const Plant& plant, std::vector<std::vector<VariableId>>& questions) {
  Plant extended = plant;
  for (const Component& component : plant.components) {
    auto& ids = questions.emplace_back();
    for (std::size_t t = 0; t < component.transitions.size(); ++t) {
      ids.push_back(extended.variables.add({component.name + "?" + std::to_string(t), {"no", "yes"}}));
    }
  }
  return extended;
}

/// The formula with some variables replaced by their values; constants are left to the encoder.
Formula substituted(const Formula& formula, const std::function<std::optional<ValueId>(VariableId)>& value_of) {
  switch (formula.kind) {
    case Formula::Kind::constant:
    case Formula::Kind::clock:
      return formula;
    case Formula::Kind::member: {
      const auto value = value_of(formula.variable);
      if (!value) return formula;
      return automata::constant(std::binary_search(formula.values.begin(), formula.values.end(), *value));
    }
    case Formula::Kind::equality: {
      const auto left = value_of(formula.variable);
      const auto right = value_of(formula.other);
      if (left && right) return automata::constant(*left == *right);
      if (left) return automata::is(formula.other, *left);
      if (right) return automata::is(formula.variable, *right);
      return formula;
    }
    case Formula::Kind::negation:
    case Formula::Kind::conjunction:
    case Formula::Kind::disjunction:
    case Formula::Kind::implication:
    case Formula::Kind::equivalence: {
      Formula result = formula;
      for (Formula& operand : result.operands) operand = substituted(operand, value_of);
      return result;
    }
  }
  return formula;
}

bool reads(const Formula& formula, const std::vector<bool>& set) {
  const auto variables = variables_of(formula);
  return std::any_of(variables.begin(), variables.end(), [&](VariableId v) { return set[v.index()]; });
}

/// How many controls a support needs off their idle values.
std::size_t commanded_controls(const Plant& plant, const Support& support) {
  return static_cast<std::size_t>(std::count_if(support.begin(), support.end(), [&](const Requirement& r) {
    return std::any_of(plant.controls.begin(), plant.controls.end(), [&](const automata::Control& control) {
      return control.variable == r.variable && !std::binary_search(r.values.begin(), r.values.end(), control.idle);
    });
  }));
}

Formula formula_of(const Support& support) {
  std::vector<Formula> parts;
  for (const Requirement& r : support) parts.push_back(member(r.variable, r.values));
  return automata::conjunction(std::move(parts));
}

}  // namespace

bool needs_no_command(const Plant& plant, const Support& support) { return commanded_controls(plant, support) == 0; }

/// One guard in one source mode: what is asked, and what may be decided to bring it about.
struct SupportFinder::Question {
  ComponentId component;
  Assignment asked;   ///< assumed where the guard is wanted and what is excluded stays excluded
  Assignment source;  ///< the component's own mode
  const Formula& guard;
  Theory::Handle refuted;  ///< the guard's negation
  std::size_t island;
  std::vector<VariableId> decisions;   ///< mode variables of the other components, then controls
  std::vector<VariableId> attributes;  ///< the rest of the island
};

SupportFinder::SupportFinder(const Plant& plant, const Islands& islands)
    : plant_(with_questions(plant, questions_)), islands_(islands), theory_(model_theory(plant_, automata::Theory::Upkeep::searched)) {}

std::vector<Support> SupportFinder::supports(ComponentId component, TransitionId transition) {
  const auto& t = plant_[component].transitions[transition.index()];
  Question question{.component = component,
                    .asked = {questions_[component.index()][transition.index()], ValueId(yes)},
                    .source = {plant_[component].mode, ValueId(t.from.index())},
                    .guard = t.guard,
                    .refuted = theory_.encode(negation(t.guard)),
                    .island = islands_.of(component),
                    .decisions = {},
                    .attributes = {}};
  std::vector<bool> decided(plant_.variables.size());
  decided[question.source.variable.index()] = true;
  const auto decide = [&](VariableId v) {
    if (decided[v.index()]) return;
    decided[v.index()] = true;
    question.decisions.push_back(v);
  };
  for (const ComponentId c : islands_.components(question.island)) decide(plant_[c].mode);
  for (const std::size_t i : islands_.controls(question.island)) decide(plant_.controls[i].variable);
  for (const VariableId v : islands_.variables(question.island)) {
    if (!decided[v.index()]) question.attributes.push_back(v);
  }
  theory_.tell_if(question.asked, t.guard);

  std::vector<Support> found;
  const std::vector<Assignment> wanted{question.asked, question.source};
  while (found.size() < limit && theory_.consistent(wanted)) {
    const World proposal = read_world(question);
    std::vector<Assignment> decisions{question.source};
    for (const VariableId v : question.decisions) decisions.push_back({v, proposal[v.index()]});
    if (theory_.allows(decisions, question.refuted)) {
      exclude(question, proposal);
    } else {
      Support support = shrink(question);
      widen(question, support);
      theory_.tell_if(question.asked, negation(formula_of(support)));
      found.push_back(std::move(support));
    }
  }

  const auto rank = [&](const Support& support) {
    return std::make_tuple(commanded_controls(plant_, support), support.size());
  };
  std::sort(found.begin(), found.end(), [&](const Support& a, const Support& b) {
    return std::tuple_cat(rank(a), std::tie(a)) < std::tuple_cat(rank(b), std::tie(b));
  });
  return found;
}

bool SupportFinder::possible(ComponentId component, automata::ModeId mode) {
  return theory_.consistent(std::vector<Assignment>{{plant_[component].mode, ValueId(mode.index())}});
}

SupportFinder::World SupportFinder::read_world(const Question& question) const {
  World world(plant_.variables.size());
  for (const VariableId v : islands_.variables(question.island)) world[v.index()] = theory_.value(v);
  return world;
}

/// After the decisions were found to imply the guard: those that are needed for it, one value each.
Support SupportFinder::shrink(const Question& question) {
  std::vector<Assignment> core = theory_.conflict();
  std::erase(core, question.source);
  for (std::size_t i = 0; i < core.size();) {
    std::vector<Assignment> rest{question.source};
    for (std::size_t j = 0; j < core.size(); ++j) {
      if (j != i) rest.push_back(core[j]);
    }
    if (theory_.allows(rest, question.refuted)) {
      ++i;
    } else {
      core.assign(rest.begin() + 1, rest.end());
    }
  }
  std::sort(core.begin(), core.end());
  Support support;
  for (const Assignment& a : core) support.push_back({a.variable, {a.value}});
  return support;
}

/// Adds each value with which the support stays one, whatever the others are, and which the store permits.
void SupportFinder::widen(const Question& question, Support& support) {
  for (std::size_t i = 0; i < support.size(); ++i) {
    Support others = support;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const Formula context = formula_of(others);
    const auto permitted = theory_.encode(context);
    const auto refuted = theory_.encode(automata::conjunction({context, negation(question.guard)}));
    const VariableId variable = support[i].variable;
    std::vector<ValueId> values;
    for (std::size_t v = 0; v < plant_.variables[variable].values.size(); ++v) {
      const std::vector<Assignment> with{question.source, {variable, ValueId(v)}};
      if (theory_.allows(with, permitted) && !theory_.allows(with, refuted)) values.emplace_back(v);
    }
    support[i].values = std::move(values);
  }
}

/// After the proposal's decisions were found not to imply the guard. A refuting world is looked for that keeps as many
/// attributes as the proofs of its impossibility allow; D are those that change. Whatever world the values of D, put in
/// place of its own, turn into one that satisfies the store and refutes the guard, it proposes no support: its own
/// decisions admit that other world. Only constraints that read D can tell, so only those are in what is excluded.
void SupportFinder::exclude(const Question& question, const World& proposal) {
  std::vector<Assignment> fixed{question.source};
  for (const VariableId v : question.decisions) fixed.push_back({v, proposal[v.index()]});
  std::vector<Assignment> kept;
  for (const VariableId v : question.attributes) kept.push_back({v, proposal[v.index()]});
  for (;;) {
    std::vector<Assignment> assumptions = fixed;
    assumptions.insert(assumptions.end(), kept.begin(), kept.end());
    if (theory_.allows(assumptions, question.refuted)) break;
    const std::vector<Assignment> blamed = theory_.conflict();
    std::erase_if(kept,
                  [&](const Assignment& a) { return std::find(blamed.begin(), blamed.end(), a) != blamed.end(); });
  }
  const World refuting = read_world(question);
  std::vector<bool> changed(plant_.variables.size());
  for (const VariableId v : question.attributes) changed[v.index()] = refuting[v.index()] != proposal[v.index()];

  const auto value_of = [&](VariableId v) {
    return changed[v.index()] ? std::optional(refuting[v.index()]) : std::nullopt;
  };
  std::vector<Formula> parts{negation(substituted(question.guard, value_of))};
  for (const Formula& interconnection : plant_.interconnections) {
    if (reads(interconnection, changed)) parts.push_back(substituted(interconnection, value_of));
  }
  for (const ComponentId c : islands_.components(question.island)) {
    const Component& component = plant_[c];
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const Formula& constraint = component.modes[m].constraint;
      if (!reads(constraint, changed)) continue;
      parts.push_back(implication(is(component.mode, ValueId(m)), substituted(constraint, value_of)));
    }
  }
  theory_.tell_if(question.asked, negation(automata::conjunction(std::move(parts))));
}

}  // namespace runtime
