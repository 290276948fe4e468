// Recognising fault trees.
// SPDX-License-Identifier: MIT
#include "verifier/safety/static_tree.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "verifier/safety/structure.hpp"

namespace rmpl::verifier {

using automata::Component;
using automata::ComponentId;
using automata::Formula;
using automata::ModeId;
using automata::Plant;
using automata::Transition;
using automata::ValueId;
using automata::VariableId;

namespace {

/// Not a fault tree.
struct Dynamic {};

/// The event that a component is; nothing where nothing ever happens to it.
std::optional<BasicEvent> event_of(const Plant& plant, ComponentId id) {
  const Component& component = plant[id];
  std::optional<ModeId> start, other;
  for (std::size_t m = 0; m < component.modes.size(); ++m) {
    if (!component.modes[m].constraint.is_true()) throw Dynamic{};
    if (component.initial[m] == 0) continue;
    if (other) throw Dynamic{};
    (start ? other : start) = ModeId(m);
  }
  if (!start) throw Dynamic{};
  if (other) {
    if (component.modes[start->index()].fault) std::swap(start, other);
    if (component.modes[start->index()].fault || !component.modes[other->index()].fault ||
        !component.transitions.empty()) {
      throw Dynamic{};
    }
    const automata::Weight weight{automata::Weight::Kind::probability, component.initial[other->index()]};
    return BasicEvent{{id, *other}, *start, weight, true, true};
  }
  std::optional<BasicEvent> event;
  bool leaves = false;
  for (const Transition& t : component.transitions) {
    if (t.from != *start || t.timing || !t.guard.is_true()) throw Dynamic{};
    if (t.to == *start) throw Dynamic{};
    if (component.is_fault(t)) {
      if (event) throw Dynamic{};
      event = BasicEvent{{id, t.to}, t.from, t.weight};
    } else {
      // What is certain is so whatever it weighs.
      if (leaves || (t.weight.kind != automata::Weight::Kind::none && t.weight.value == 0)) throw Dynamic{};
      leaves = true;
    }
  }
  if (event && leaves) {
    // A rate beside what happens at once weighs by the length of a step.
    if (event->weight.kind == automata::Weight::Kind::rate) throw Dynamic{};
    event->once = true;
  }
  if (!event && leaves) throw Dynamic{};
  return event;
}

class Builder {
 public:
  explicit Builder(const Plant& plant) : plant_(plant) {
    for (const automata::Interconnection& q : plant.interconnections) {
      const Formula& f = q.constraint;
      if (f.kind != Formula::Kind::equivalence || f.operands[0].kind != Formula::Kind::member) throw Dynamic{};
      const Formula& defined = f.operands[0];
      if (plant.component_of(defined.variable) || defined.values.size() != 1 ||
          plant.variables[defined.variable].values.size() != 2 || !definitions_.emplace(defined.variable, &f).second) {
        throw Dynamic{};
      }
    }
    for (const auto& [variable, formula] : definitions_) check_order(variable);
  }

  StaticTree run(const Formula& formula, Diagrams& diagrams) {
    const GateId top = structure_.simplified(gate_of(formula, true));
    std::vector<std::uint32_t> order = structure_.order(top);
    // What the top does not depend on comes last.
    std::vector<bool> tested(tree_.events.size(), false);
    for (const std::uint32_t event : order) tested[event] = true;
    for (std::uint32_t event = 0; event < tested.size(); ++event) {
      if (!tested[event]) order.push_back(event);
    }
    tree_.variables.resize(order.size());
    for (std::uint32_t variable = 0; variable < order.size(); ++variable) tree_.variables[order[variable]] = variable;
    tree_.top = structure_.diagram(top, tree_.variables, diagrams);
    return std::move(tree_);
  }

 private:
  /// Definitions that lead back to themselves may contradict each other. Takes no stack for their length.
  void check_order(VariableId root) {
    if (order_[root] == 2) return;
    std::vector<std::pair<VariableId, bool>> open{{root, false}};
    while (!open.empty()) {
      const auto [variable, done] = open.back();
      open.pop_back();
      int& state = order_[variable];
      if (done) {
        state = 2;
        continue;
      }
      if (state == 2) continue;
      if (state == 1) throw Dynamic{};
      state = 1;
      open.emplace_back(variable, true);
      for (const VariableId read : automata::variables_of(definitions_.at(variable)->operands[1])) {
        const auto at = definitions_.find(read);
        if (at != definitions_.end() && order_[read] != 2) {
          if (order_[read] == 1) throw Dynamic{};
          open.emplace_back(read, false);
        }
      }
    }
  }

  GateId gate_of(const Formula& f, bool positive) {
    switch (f.kind) {
      case Formula::Kind::constant:
        return f.truth ? Structure::one : Structure::zero;
      case Formula::Kind::member:
        return member(f, positive);
      case Formula::Kind::negation:
        return structure_.negation(gate_of(f.operands[0], !positive));
      case Formula::Kind::conjunction:
        return structure_.conjunction(gates_of(f.operands, positive));
      case Formula::Kind::disjunction:
        return structure_.disjunction(gates_of(f.operands, positive));
      case Formula::Kind::implication: {
        const GateId condition = gate_of(f.operands[0], !positive);
        return structure_.disjunction({structure_.negation(condition), gate_of(f.operands[1], positive)});
      }
      case Formula::Kind::equivalence: {
        tree_.monotone = false;
        const GateId left = gate_of(f.operands[0], positive);
        return structure_.equivalence(left, gate_of(f.operands[1], positive));
      }
      case Formula::Kind::equality:
      case Formula::Kind::clock:
      case Formula::Kind::knowledge:
        break;
    }
    throw Dynamic{};
  }

  std::vector<GateId> gates_of(const std::vector<Formula>& operands, bool positive) {
    std::vector<GateId> result;
    result.reserve(operands.size());
    for (const Formula& operand : operands) result.push_back(gate_of(operand, positive));
    return result;
  }

  GateId member(const Formula& f, bool positive) {
    if (const auto component = plant_.component_of(f.variable)) return mode(*component, f.values, positive);
    const auto at = definitions_.find(f.variable);
    if (at == definitions_.end()) throw Dynamic{};
    const std::size_t values = plant_.variables[f.variable].values.size();
    if (f.values.empty()) return Structure::zero;
    if (f.values.size() == values) return Structure::one;
    const ValueId defined = at->second->operands[0].values.front();
    const bool same = f.values.front() == defined;
    const GateId result = definition(f.variable, at->second->operands[1], same == positive);
    return same ? result : structure_.negation(result);
  }

  GateId definition(VariableId variable, const Formula& f, bool positive) {
    if (const auto known = built_.find({variable, positive}); known != built_.end()) return known->second;
    const GateId result = gate_of(f, positive);
    built_.emplace(std::pair{variable, positive}, result);
    return result;
  }

  GateId mode(ComponentId component, const std::vector<ValueId>& values, bool positive) {
    const auto [at, fresh] = variables_.try_emplace(component);
    if (fresh) {
      if (const auto event = event_of(plant_, component)) {
        at->second = static_cast<std::uint32_t>(tree_.events.size());
        tree_.events.push_back(*event);
      }
    }
    const auto holds = [&](ModeId mode) {
      return std::find(values.begin(), values.end(), ValueId(mode.index())) != values.end();
    };
    if (!at->second) {
      const auto& initial = plant_[component].initial;
      const auto start = std::find_if(initial.begin(), initial.end(), [](double p) { return p > 0; });
      return holds(ModeId(static_cast<std::size_t>(start - initial.begin()))) ? Structure::one : Structure::zero;
    }
    const BasicEvent& event = tree_.events[*at->second];
    // What is neither failed nor as it started is sound too; a formula that tells the two apart sees the first step.
    const bool failed = holds(event.fault.mode);
    bool sound = holds(event.from);
    for (const Transition& t : plant_[component].transitions) {
      if (t.to != event.fault.mode && holds(t.to) != sound) throw Dynamic{};
    }
    if (failed == sound) return failed ? Structure::one : Structure::zero;
    const GateId variable = structure_.event(*at->second);
    if (failed != positive) tree_.monotone = false;
    return failed ? variable : structure_.negation(variable);
  }

  const Plant& plant_;
  Structure structure_;
  std::map<VariableId, const Formula*> definitions_;
  std::map<VariableId, int> order_;  ///< 1: being looked at, 2: leads to no loop
  std::map<std::pair<VariableId, bool>, GateId> built_;
  std::map<ComponentId, std::optional<std::uint32_t>> variables_;
  StaticTree tree_;
};

}  // namespace

std::optional<StaticTree> static_tree(const Plant& plant, const Formula& formula, Diagrams& diagrams) {
  try {
    return Builder(plant).run(formula, diagrams);
  } catch (const Dynamic&) {
    return std::nullopt;
  }
}

Enclosure chance_of(const BasicEvent& event, std::optional<automata::Ticks> within,
                    std::optional<automata::Ticks> period) {
  constexpr Real error = 2e-14L;
  const auto about = [](Real p) { return as_probability(outward({p * (1 - error), p * (1 + error)}, 4)); };
  const auto value = static_cast<Real>(event.weight.value);
  if (value == 0) return {};
  const bool any_time = !within || within->is_infinite();
  const std::int64_t steps = any_time || !period ? 0 : within->count / period->count;
  if (event.once) {
    // In dense time at once.
    return !event.from_start && !any_time && period && steps == 0 ? Enclosure{} : about(value);
  }
  if (any_time) return certain();
  if (event.weight.kind == automata::Weight::Kind::rate) {
    const Real seconds =
        period ? static_cast<Real>(steps) * static_cast<Real>(period->count) : static_cast<Real>(within->count);
    return about(-std::expm1(-value * seconds / automata::Ticks::per_second));
  }
  if (value >= 1) return steps > 0 ? certain() : Enclosure{};
  return about(-std::expm1(static_cast<Real>(steps) * std::log1p(-value)));
}

}  // namespace rmpl::verifier
