// A decision tree over the modes and controls that a formula depends on; what the rest cannot change ends a branch.
// SPDX-License-Identifier: MIT
#include "automata/software/untold.hpp"

#include <algorithm>
#include <span>
#include <string>

#include "automata/store/model.hpp"
#include "base/limit_error.hpp"

namespace rmpl::automata {
namespace {

constexpr std::size_t most_questions = std::size_t{1} << 14;

/// The atoms of a formula of states.
void collect_atoms(const Formula& formula, std::vector<Formula>& atoms) {
  if (formula.kind == Formula::Kind::member || formula.kind == Formula::Kind::equality) atoms.push_back(formula);
  for (const Formula& operand : formula.operands) collect_atoms(operand, atoms);
}

}  // namespace

Untold::Untold(const Plant& plant)
    : plant_(plant),
      dependencies_(plant),
      known_(plant, dependencies_.index(), constraints_of(plant), std::span<const Assignment>()),
      locality_(Dependencies(plant, known_.constraints()), Locality::Commanded::yes),
      theory_(model_theory(plant)) {}

bool Untold::possible(const Formula& formula, Assignment mode) {
  return theory_.allows({&mode, 1}, theory_.encode(formula));
}

Formula Untold::of(const Formula& constraint, Assignment mode) {
  std::vector<Formula> parts;
  for (const Formula& conjunct : conjuncts_of(constraint)) {
    parts.push_back(settled(conjunct, mode) ? otherwise(conjunct) : decided(conjunct, mode).untold);
  }
  return disjunction(std::move(parts));
}

/// The negation, of an atom as another atom.
Formula Untold::otherwise(const Formula& formula) const {
  if (formula.kind != Formula::Kind::member) return negation(formula);
  std::vector<ValueId> others;
  for (std::size_t v = 0; v < plant_.variables[formula.variable].values.size(); ++v) {
    if (!std::binary_search(formula.values.begin(), formula.values.end(), ValueId(v))) others.emplace_back(v);
  }
  return others.empty() ? constant(false) : member(formula.variable, std::move(others));
}

/// Whether every consistent store with the mode implies the formula or its negation, as far as its atoms tell.
bool Untold::settled(const Formula& formula, Assignment mode) {
  std::vector<Formula> atoms;
  collect_atoms(formula, atoms);
  return std::none_of(atoms.begin(), atoms.end(), [&](const Formula& atom) { return decided(atom, mode).open; });
}

const Untold::Decided& Untold::decided(const Formula& formula, Assignment mode) {
  const std::pair<Formula, Assignment> question{formula, mode};
  const auto known =
      std::find_if(answers_.begin(), answers_.end(), [&](const auto& one) { return one.first == question; });
  if (known != answers_.end()) return known->second;
  const Formula rewritten = known_.rewritten(formula);
  Support support = locality_.support_of(rewritten);
  for (const VariableId v : variables_of(rewritten)) {
    if (const auto component = dependencies_.index().component_of(v)) support.join({{*component}, {}});
    if (const auto control = dependencies_.index().control_of(v)) support.join({{}, {*control}});
  }
  order_.clear();
  for (const std::size_t control : support.controls) order_.push_back(plant_.controls[control].variable);
  for (const ComponentId component : support.components) {
    if (plant_[component].mode != mode.variable) order_.push_back(plant_[component].mode);
  }
  assumed_.assign(1, mode);
  questions_ = 0;
  Decided answer = decide(theory_.encode(formula), 0).value_or(Decided{constant(false), false});
  return answers_.emplace_back(question, std::move(answer)).second;
}

/// Nothing where the assumptions contradict the store.
std::optional<Untold::Decided> Untold::decide(Theory::Handle formula, std::size_t next) {
  if (++questions_ > most_questions) {
    throw base::LimitError("whether it is told depends on the modes of too many components, and on too many controls");
  }
  if (!theory_.consistent(assumed_)) return std::nullopt;
  if (theory_.entails(assumed_, formula)) return Decided{constant(false), false};
  if (next == order_.size()) return Decided{constant(true), theory_.allows(assumed_, formula)};
  if (!theory_.allows(assumed_, formula)) return Decided{constant(true), false};
  const VariableId variable = order_[next];
  std::vector<std::pair<Formula, std::vector<ValueId>>> groups;
  bool open = false;
  for (std::size_t v = 0; v < plant_.variables[variable].values.size(); ++v) {
    assumed_.push_back({variable, ValueId(v)});
    const std::optional<Decided> branch = decide(formula, next + 1);
    assumed_.pop_back();
    if (!branch) continue;
    open = open || branch->open;
    const auto same =
        std::find_if(groups.begin(), groups.end(), [&](const auto& group) { return group.first == branch->untold; });
    if (same == groups.end()) {
      groups.emplace_back(branch->untold, std::vector<ValueId>{ValueId(v)});
    } else {
      same->second.emplace_back(v);
    }
  }
  if (groups.empty()) return std::nullopt;
  if (groups.size() == 1) return Decided{std::move(groups.front().first), open};
  std::vector<Formula> ways;
  for (auto& [untold, values] : groups) {
    if (untold.kind == Formula::Kind::constant && !untold.truth) continue;
    Formula here = member(variable, std::move(values));
    ways.push_back(untold.is_true() ? std::move(here) : conjunction({std::move(here), std::move(untold)}));
  }
  return Decided{disjunction(std::move(ways)), open};
}

}  // namespace rmpl::automata
