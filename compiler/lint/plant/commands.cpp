// Findings: command values that nothing allows, or that nothing reads.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "automata/state.hpp"
#include "base/partition.hpp"
#include "compiler/lint/plant/findings.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Formula;
using automata::Plant;
using automata::ValueId;
using automata::VariableId;

std::vector<Assignment> find_impossible_commands(PlantAnalysis& analysis) {
  std::vector<Assignment> found;
  const Plant& plant = analysis.plant();
  for (const automata::Control& control : plant.controls) {
    for (std::size_t v = 0; v < plant.variables[control.variable].values.size(); ++v) {
      const Assignment command{control.variable, ValueId(v)};
      if (!analysis.questions().possible({&command, 1})) found.push_back(command);
    }
  }
  return found;
}

std::vector<IdleContradiction> find_idle_contradictions(PlantAnalysis& analysis) {
  std::vector<IdleContradiction> found;
  const Plant& plant = analysis.plant();
  PlantQuestions& questions = analysis.questions();
  // Only commands of its own part of the plant can contradict a mode.
  const automata::Classes& parts = questions.parts();
  std::vector<std::vector<Assignment>> idle_in(parts.count);
  for (const Assignment& one : automata::assignments_of(plant, automata::idle_action(plant))) {
    if (const auto part = parts[one.variable]) idle_in[*part].push_back(one);
  }
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const auto part = parts[plant.components[c].mode];
    if (!part || idle_in[*part].empty()) continue;
    const std::vector<Assignment>& idle = idle_in[*part];
    std::vector<Assignment> together = idle;
    Assignment& mode = together.emplace_back();
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      mode = {plant.components[c].mode, ValueId(m)};
      if (!analysis.reach().reached[c][m] || questions.possible(together) || !questions.possible({&mode, 1})) continue;
      IdleContradiction contradiction{{automata::ComponentId(c), automata::ModeId(m)}, {}};
      for (const Assignment& one : idle) {
        if (!questions.possible(std::array{one, mode})) contradiction.idle.push_back(one);
      }
      if (contradiction.idle.empty()) contradiction.idle = idle;
      found.push_back(std::move(contradiction));
    }
  }
  return found;
}

namespace {

/// Variables that equalities join, and the sets of values by which any of them is asked.
class ValueReaders {
 public:
  explicit ValueReaders(const Plant& plant) : joined_(plant.variables.size()), sets_(plant.variables.size()) {
    for_each_formula(plant, [this](const Formula& formula) { join(formula); });
    for_each_formula(plant, [this](const Formula& formula) { collect(formula); });
    for (const automata::Control& control : plant.controls) controls_.insert(control.variable);
    for (const VariableId v : plant.observables) {
      if (!controls_.contains(v)) seen_.insert(joined_.root(v.index()));
    }
    // Two controls that are joined, or one with a mode: not a matter of one value any more.
    std::set<std::size_t> once;
    for (const automata::Control& control : plant.controls) {
      if (!once.insert(joined_.root(control.variable.index())).second)
        seen_.insert(joined_.root(control.variable.index()));
    }
    for (const automata::Component& component : plant.components) seen_.insert(joined_.root(component.mode.index()));
  }

  /// Whether the values can be exchanged wherever the variable's are read.
  bool interchangeable(VariableId variable, ValueId a, ValueId b) {
    const std::size_t root = joined_.root(variable.index());
    if (seen_.contains(root)) return false;
    return std::all_of(sets_[root].begin(), sets_[root].end(), [&](const std::vector<ValueId>& values) {
      return std::binary_search(values.begin(), values.end(), a) == std::binary_search(values.begin(), values.end(), b);
    });
  }

 private:
  template <class Visit>
  static void for_each_formula(const Plant& plant, const Visit& visit) {
    for (const automata::Interconnection& q : plant.interconnections) visit(q.constraint);
    for (const automata::Component& component : plant.components) {
      for (const automata::Mode& mode : component.modes) visit(mode.constraint);
      for (const automata::Transition& transition : component.transitions) visit(transition.guard);
    }
  }

  void join(const Formula& formula) {
    if (formula.kind == Formula::Kind::equality) joined_.join(formula.variable.index(), formula.other.index());
    for (const Formula& operand : formula.operands) join(operand);
  }
  void collect(const Formula& formula) {
    if (formula.kind == Formula::Kind::member) sets_[joined_.root(formula.variable.index())].insert(formula.values);
    for (const Formula& operand : formula.operands) collect(operand);
  }

  base::Partition joined_;
  std::vector<std::set<std::vector<ValueId>>> sets_;  ///< by root
  std::set<VariableId> controls_;
  std::set<std::size_t> seen_;  ///< roots of what is observed
};

}  // namespace

std::vector<Assignment> find_unread_commands(const PlantAnalysis& analysis) {
  std::vector<Assignment> found;
  const Plant& plant = analysis.plant();
  ValueReaders readers(plant);
  for (const automata::Control& control : plant.controls) {
    for (std::size_t v = 0; v < plant.variables[control.variable].values.size(); ++v) {
      if (ValueId(v) == control.idle || !readers.interchangeable(control.variable, control.idle, ValueId(v))) continue;
      found.push_back({control.variable, ValueId(v)});
    }
  }
  return found;
}

}  // namespace rmpl::compiler
