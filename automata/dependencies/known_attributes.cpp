// SPDX-License-Identifier: MIT
#include "automata/dependencies/known_attributes.hpp"

#include <algorithm>
#include <utility>

#include "automata/logic/folding.hpp"

namespace rmpl::automata {
namespace {

/// How many pairs of a mode and a value one constraint is evaluated for.
constexpr std::size_t most_pairs = 1u << 12;

}  // namespace

KnownAttributes::KnownAttributes(const Plant& plant, const PlantIndex& index,
                                 const std::vector<Constraint>& constraints, std::span<const Assignment> given)
    : plant_(plant), index_(index) {
  for (const Assignment& a : given) known_[a.variable] = {std::nullopt, {a.value}};
  for (const Constraint& constraint : constraints) {
    Told told{constraint, {}, false, false};
    if (!given.empty()) told.constraint.formula = rewritten(constraint.formula, constraint.under);
    if (told.constraint.formula.is_true()) continue;
    told.variables = variables_of(told.constraint.formula);
    for (const VariableId v : told.variables) readers_[v].push_back(told_.size());
    open_.push_back(told_.size());
    told_.push_back(std::move(told));
  }
  // In the order in which they are told: what is known does not depend on it, but the text of what is left may.
  std::reverse(open_.begin(), open_.end());
  while (!open_.empty() || !new_.empty()) {
    if (!new_.empty()) {
      const VariableId attribute = new_.back();
      new_.pop_back();
      for (const std::size_t reader : readers_[attribute]) rewrite(reader);
      continue;
    }
    const std::size_t next = open_.back();
    open_.pop_back();
    look_at(next);
  }
  for (Told& told : told_) {
    if (!told.gone) constraints_.push_back(std::move(told.constraint));
  }
  told_ = {};
  readers_.clear();
  pins_.clear();
}

bool KnownAttributes::is_open_attribute(VariableId variable) const {
  return !index_.component_of(variable) && !index_.control_of(variable) && !known_.contains(variable);
}

std::optional<ValueId> KnownAttributes::only_value(const Formula& formula, VariableId attribute,
                                                   std::optional<Assignment> given) const {
  std::optional<ValueId> only;
  for (std::size_t value = 0; value < plant_.variables[attribute].values.size(); ++value) {
    const bool holds =
        evaluate(formula, [&](VariableId v) { return v == attribute || !given ? ValueId(value) : given->value; });
    if (!holds) continue;
    if (only) return std::nullopt;
    only = ValueId(value);
  }
  return only;
}

void KnownAttributes::look_at(std::size_t number) {
  const Told& told = told_[number];
  if (told.gone || told.defines) return;
  std::optional<VariableId> attribute;
  std::optional<ComponentId> component;
  if (told.constraint.under) component = index_.component_of(told.constraint.under->variable);
  for (const VariableId v : told.variables) {
    if (const auto read = index_.component_of(v)) {
      if (component && *component != *read) return;
      component = read;
    } else if (!is_open_attribute(v) || attribute) {
      return;
    } else {
      attribute = v;
    }
  }
  if (!attribute) return;
  const Formula& formula = told.constraint.formula;
  const std::size_t values = plant_.variables[*attribute].values.size();
  if (!component) {
    const auto only = only_value(formula, *attribute, std::nullopt);
    if (!only) return;
    told_[number].defines = true;
    know(*attribute, {std::nullopt, {*only}});
    return;
  }
  const std::vector<Mode>& modes = plant_[*component].modes;
  const VariableId mode = plant_[*component].mode;
  if (const auto under = told.constraint.under) {
    // A formula under a mode speaks of no mode but that.
    const auto only = only_value(formula, *attribute, under);
    if (!only) return;
    Pins& pins = pins_[{*attribute, *component}];
    pins.try_emplace(ModeId(under->value.value), Pin{*only, number});
    if (pins.size() < modes.size()) return;
    Known known{*component, {}};
    for (const auto& [at, pin] : pins) {
      known.values.push_back(pin.value);
      told_[pin.constraint].defines = true;
    }
    know(*attribute, std::move(known));
    return;
  }
  if (values * modes.size() > most_pairs) return;
  Known known{*component, {}};
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const auto only = only_value(formula, *attribute, Assignment{mode, ValueId(m)});
    if (!only) return;
    known.values.push_back(*only);
  }
  // Told mode by mode, it is read under each.
  told_[number].gone = true;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    told_.push_back({{Assignment{mode, ValueId(m)}, is(*attribute, known.values[m])}, {*attribute}, true, false});
  }
  know(*attribute, std::move(known));
}

void KnownAttributes::know(VariableId attribute, Known known) {
  if (std::all_of(known.values.begin(), known.values.end(), [&](ValueId v) { return v == known.values.front(); })) {
    known = {std::nullopt, {known.values.front()}};
  }
  known_.emplace(attribute, std::move(known));
  new_.push_back(attribute);
}

void KnownAttributes::rewrite(std::size_t number) {
  Told& told = told_[number];
  if (told.gone || told.defines) return;
  Constraint& constraint = told.constraint;
  if (constraint.formula.kind == Formula::Kind::equality && !constraint.under) {
    // The other side is known by the same component: told mode by mode, so that many values cost no more than once.
    const VariableId one = constraint.formula.variable;
    const VariableId two = constraint.formula.other;
    const VariableId open = known_.contains(one) ? two : one;
    const auto other = known_.find(open == one ? two : one);
    if (other != known_.end() && is_open_attribute(open)) {
      const Known known = other->second;
      told.gone = true;
      if (!known.component) told_.push_back({{std::nullopt, is(open, known.values.front())}, {open}, true, false});
      for (std::size_t m = 0; known.component && m < known.values.size(); ++m) {
        const Assignment under{plant_[*known.component].mode, ValueId(m)};
        told_.push_back({{under, is(open, known.values[m])}, {open}, true, false});
      }
      know(open, known);
      return;
    }
  }
  constraint.formula = rewritten(constraint.formula, constraint.under);
  told.gone = constraint.formula.is_true();
  told.variables = variables_of(constraint.formula);
  for (const VariableId v : told.variables) {
    std::vector<std::size_t>& readers = readers_[v];
    if (readers.empty() || readers.back() != number) readers.push_back(number);
  }
  open_.push_back(number);
}

Formula KnownAttributes::member_of(VariableId variable, const std::vector<ValueId>& values,
                                   std::optional<Assignment> under) const {
  const auto has = [&](ValueId value) { return std::binary_search(values.begin(), values.end(), value); };
  if (under && under->variable == variable) return constant(has(under->value));
  if (values.size() == plant_.variables[variable].values.size()) return constant(true);
  const auto at = known_.find(variable);
  if (at == known_.end()) return member(variable, values);
  const Known& known = at->second;
  if (!known.component) return constant(has(known.values.front()));
  std::vector<ValueId> modes;
  for (std::size_t m = 0; m < known.values.size(); ++m) {
    if (has(known.values[m])) modes.emplace_back(m);
  }
  if (modes.empty()) return constant(false);
  return member_of(plant_[*known.component].mode, modes, under);
}

Formula KnownAttributes::equality_of(VariableId one, VariableId other, std::optional<Assignment> under) const {
  const bool is_known = known_.contains(one);
  if (!is_known && !known_.contains(other)) return equality(one, other);
  if (!is_known) std::swap(one, other);
  std::vector<ValueId> values = known_.at(one).values;
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<Formula> cases;
  cases.reserve(values.size());
  for (const ValueId value : values) {
    cases.push_back(
        folded(Formula::Kind::conjunction, {member_of(one, {value}, under), member_of(other, {value}, under)}));
  }
  return folded(Formula::Kind::disjunction, std::move(cases));
}

Formula KnownAttributes::rewritten(const Formula& formula, std::optional<Assignment> under) const {
  if (formula.kind == Formula::Kind::member) return member_of(formula.variable, formula.values, under);
  if (formula.kind == Formula::Kind::equality) return equality_of(formula.variable, formula.other, under);
  if (formula.operands.empty() || formula.kind == Formula::Kind::knowledge) return formula;
  std::vector<Formula> operands;
  operands.reserve(formula.operands.size());
  for (const Formula& operand : formula.operands) operands.push_back(rewritten(operand, under));
  return folded(formula.kind, std::move(operands));
}

}  // namespace rmpl::automata
