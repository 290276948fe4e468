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
      bind_goal(location);
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

  /// An assignment of an attribute is a constraint: components alone have modes.
  void bind_goal(Location& location) {
    std::vector<Formula> constraints;
    for (const Assignment& assigned : std::exchange(location.goal, {})) {
      const Formula bound = bind(is(assigned.variable, assigned.value));
      const bool mode = bound.kind == Formula::Kind::member && plant_.component_of(bound.variable).has_value();
      if (mode && bound.values.size() == 1) {
        location.goal.push_back({bound.variable, bound.values.front()});
      } else {
        constraints.push_back(bound);
      }
    }
    for (const Formula& constraint : location.goal_constraints) constraints.push_back(bind(constraint));
    location.goal_constraints = std::move(constraints);
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
    if (formula.kind == Formula::Kind::knowledge && formula.about_one) {
      const auto known = variable(formula.variable);
      if (known && !plant_.component_of(*known)) report("'" + plant_.variables.name(*known) + "' is no component");
      result.variable = known.value_or(formula.variable);
    }
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

Formula goal_of(const Location& location) {
  std::vector<Formula> conjuncts;
  for (const Assignment& assigned : location.goal) conjuncts.push_back(is(assigned.variable, assigned.value));
  conjuncts.insert(conjuncts.end(), location.goal_constraints.begin(), location.goal_constraints.end());
  return conjunction(std::move(conjuncts));
}

std::vector<std::size_t> goal_parts_of(const Program& program) {
  std::vector<std::size_t> parts;
  std::size_t count = 0;
  for (const Location& location : program.locations) {
    const std::size_t around = location.parent ? parts[location.parent->index()] : 0;
    parts.push_back(location.apart ? ++count : around);
  }
  return parts;
}

std::vector<Formula> knowledge_asked_by(const Program& program) {
  std::vector<Formula> atoms;
  for (const Location& location : program.locations) {
    collect_knowledge(location.maintenance.constraint, atoms);
    for (const Arc& arc : location.arcs) collect_knowledge(arc.guard.constraint, atoms);
  }
  return atoms;
}

Binding bind(const Program& program, const Plant& plant) { return Binder(program, plant).run(); }

}  // namespace rmpl::automata
