// Binding a control program to a plant: names become the plant's variables and values.
// SPDX-License-Identifier: MIT
#include "automata/program.hpp"

#include <set>
#include <tuple>
#include <utility>

namespace rmpl::automata {
namespace {

bool comes_before(const Mismatch& a, const Mismatch& b) {
  const auto key = [](const Mismatch& m) { return std::tie(m.origin.file, m.origin.line, m.origin.column, m.message); };
  return key(a) < key(b);
}

/// Rewrites one program; collects every name that the plant lacks, so that all are reported at once.
class Binder {
 public:
  Binder(const Program& program, const Plant& plant) : program_(program), plant_(plant) {}

  Binding run() {
    Program bound = program_;
    bound.variables = plant_.variables;
    for (Location& location : bound.locations) {
      origin_ = &location.origin;
      for (Assignment& goal : location.goal) goal = bind(goal);
      location.maintenance.constraint = bind(location.maintenance.constraint);
      for (Arc& arc : location.arcs) arc.guard.constraint = bind(arc.guard.constraint);
    }
    return {std::move(bound), {problems_.begin(), problems_.end()}};
  }

 private:
  void report(std::string problem) { problems_.insert({*origin_, std::move(problem)}); }

  std::optional<VariableId> variable(VariableId id) {
    const std::string& name = program_.variables.name(id);
    const auto found = plant_.variables.find(name);
    if (!found) report("the plant '" + plant_.name + "' has no variable '" + name + "'");
    return found;
  }

  void report_value(VariableId known, const std::string& value) {
    report("'" + value + "' is no value of '" + plant_.variables.name(known) + "'");
  }

  Assignment bind(const Assignment& goal) {
    const auto known = variable(goal.variable);
    if (!known) return goal;
    const std::string& value = program_.variables.value(goal);
    const auto id = plant_.variables[*known].find(value);
    if (!id) {
      report_value(*known, value);
      return goal;
    }
    if (!plant_.component_of(*known)) report("'" + plant_.variables.name(*known) + "' is no component, so no goal");
    return {*known, *id};
  }

  Formula bind(const Formula& formula) {
    if (formula.kind == Formula::Kind::member) return bind_member(formula);
    if (formula.kind == Formula::Kind::equality) {
      const auto left = variable(formula.variable);
      const auto right = variable(formula.other);
      if (!left || !right) return formula;
      if (plant_.variables[*left].values != plant_.variables[*right].values) {
        report("'" + plant_.variables.name(*left) + "' and '" + plant_.variables.name(*right) +
               "' have different domains");
      }
      return equality(*left, *right);
    }
    Formula result = formula;
    for (Formula& operand : result.operands) operand = bind(operand);
    return result;
  }

  /// A value of an unbound program may turn out to be a variable of the plant: `x = y`.
  Formula bind_member(const Formula& formula) {
    const auto known = variable(formula.variable);
    if (!known) return formula;
    const Variable& target = plant_.variables[*known];
    std::vector<ValueId> values;
    std::vector<Formula> alternatives;
    for (const ValueId v : formula.values) {
      const std::string& value = program_.variables.value({formula.variable, v});
      const auto other = plant_.variables.find(value);
      if (const auto id = target.find(value)) {
        values.push_back(*id);
      } else if (other && plant_.variables[*other].values == target.values) {
        alternatives.push_back(equality(*known, *other));
      } else {
        report_value(*known, value);
      }
    }
    if (!values.empty() || alternatives.empty()) alternatives.push_back(member(*known, std::move(values)));
    return disjunction(std::move(alternatives));
  }

  const Program& program_;
  const Plant& plant_;
  const Origin* origin_ = nullptr;
  std::set<Mismatch, decltype(&comes_before)> problems_{&comes_before};
};

}  // namespace

Binding bind(const Program& program, const Plant& plant) { return Binder(program, plant).run(); }

}  // namespace rmpl::automata
