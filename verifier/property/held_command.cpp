// Guards in three values, where one control is known.
// SPDX-License-Identifier: MIT
#include "verifier/property/held_command.hpp"

#include <algorithm>
#include <set>

#include "automata/dependencies/plant_index.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::Component;
using automata::Formula;
using automata::ModeId;
using automata::Transition;
using automata::ValueId;

namespace {

using Truth = std::optional<bool>;  ///< nothing: either

Truth opposite(Truth truth) { return truth ? Truth(!*truth) : std::nullopt; }

Truth truth_under(const Formula& formula, Assignment known);

/// Of a disjunction, with `value` true; of a conjunction, with false.
Truth some(const std::vector<Formula>& operands, Assignment known, bool value) {
  Truth result = !value;
  for (const Formula& operand : operands) {
    const Truth truth = truth_under(operand, known);
    if (truth == value) return value;
    if (!truth) result = std::nullopt;
  }
  return result;
}

Truth truth_under(const Formula& formula, Assignment known) {
  switch (formula.kind) {
    case Formula::Kind::constant:
      return formula.truth;
    case Formula::Kind::member:
      if (formula.variable != known.variable) return std::nullopt;
      return std::binary_search(formula.values.begin(), formula.values.end(), known.value);
    case Formula::Kind::equality:
    case Formula::Kind::clock:
    case Formula::Kind::knowledge:
      return std::nullopt;
    case Formula::Kind::negation:
      return opposite(truth_under(formula.operands[0], known));
    case Formula::Kind::conjunction:
      return some(formula.operands, known, false);
    case Formula::Kind::disjunction:
      return some(formula.operands, known, true);
    case Formula::Kind::implication: {
      const Truth premise = truth_under(formula.operands[0], known);
      const Truth conclusion = truth_under(formula.operands[1], known);
      if (premise == false || conclusion == true) return true;
      return premise == true && conclusion == false ? Truth(false) : std::nullopt;
    }
    case Formula::Kind::equivalence: {
      const Truth left = truth_under(formula.operands[0], known);
      const Truth right = truth_under(formula.operands[1], known);
      return left && right ? Truth(*left == *right) : std::nullopt;
    }
  }
  return std::nullopt;
}

/// How long the mode may last: up to the least upper bound of those of its exits whose guards may hold.
automata::Ticks lasts(const Component& component, ModeId mode, Assignment known) {
  automata::Ticks result = automata::Ticks::infinite();
  for (const Transition& t : component.transitions) {
    const bool ends = t.from == mode && t.to != mode && !component.is_fault(t);
    if (!ends || truth_under(t.guard, known) == false) continue;
    result = std::min(result, t.timing ? t.timing->upper : automata::Ticks{0});
  }
  return result;
}

bool is_held(const Component& component, ModeId mode, const automata::Control& control, ValueId command) {
  return lasts(component, mode, {control.variable, control.idle}) < lasts(component, mode, {control.variable, command});
}

}  // namespace

std::optional<HeldMode> find_held_mode(const automata::Plant& plant,
                                       std::span<const automata::ComponentId> components) {
  const automata::PlantIndex index(plant);
  for (const automata::ComponentId c : components) {
    const Component& component = plant[c];
    std::set<std::size_t> read;  // positions among the controls
    for (const Transition& t : component.transitions) {
      for (const automata::VariableId v : variables_of(t.guard)) {
        if (const auto control = index.control_of(v)) read.insert(*control);
      }
    }
    for (const std::size_t position : read) {
      const automata::Control& control = plant.controls[position];
      for (std::size_t value = 0; value < plant.variables[control.variable].values.size(); ++value) {
        if (ValueId(value) == control.idle) continue;
        for (std::size_t m = 0; m < component.modes.size(); ++m) {
          if (component.modes[m].fault || !is_held(component, ModeId(m), control, ValueId(value))) continue;
          return HeldMode{c, ModeId(m), {control.variable, ValueId(value)}};
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace rmpl::verifier
