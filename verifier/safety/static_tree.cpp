// Recognising fault trees.
// SPDX-License-Identifier: MIT
#include "verifier/safety/static_tree.hpp"

#include <algorithm>
#include <cmath>
#include <map>

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
  Builder(const Plant& plant, Diagrams& diagrams) : plant_(plant), diagrams_(diagrams) {
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

  StaticTree run(const Formula& formula) {
    tree_.top = diagram_of(formula, true);
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

  NodeId diagram_of(const Formula& f, bool positive) {
    switch (f.kind) {
      case Formula::Kind::constant:
        return f.truth ? Diagrams::one : Diagrams::zero;
      case Formula::Kind::member:
        return member(f, positive);
      case Formula::Kind::negation:
        return diagrams_.negation(diagram_of(f.operands[0], !positive));
      case Formula::Kind::conjunction: {
        NodeId result = Diagrams::one;
        for (const Formula& operand : f.operands) result = diagrams_.conjunction(result, diagram_of(operand, positive));
        return result;
      }
      case Formula::Kind::disjunction: {
        NodeId result = Diagrams::zero;
        for (const Formula& operand : f.operands) result = diagrams_.disjunction(result, diagram_of(operand, positive));
        return result;
      }
      case Formula::Kind::implication:
        return diagrams_.choose(diagram_of(f.operands[0], !positive), diagram_of(f.operands[1], positive),
                                Diagrams::one);
      case Formula::Kind::equivalence: {
        tree_.monotone = false;
        const NodeId left = diagram_of(f.operands[0], positive);
        const NodeId right = diagram_of(f.operands[1], positive);
        return diagrams_.choose(left, right, diagrams_.negation(right));
      }
      case Formula::Kind::equality:
      case Formula::Kind::clock:
      case Formula::Kind::knowledge:
        break;
    }
    throw Dynamic{};
  }

  NodeId member(const Formula& f, bool positive) {
    if (const auto component = plant_.component_of(f.variable)) return mode(*component, f.values, positive);
    const auto at = definitions_.find(f.variable);
    if (at == definitions_.end()) throw Dynamic{};
    const std::size_t values = plant_.variables[f.variable].values.size();
    if (f.values.empty()) return Diagrams::zero;
    if (f.values.size() == values) return Diagrams::one;
    const ValueId defined = at->second->operands[0].values.front();
    const bool same = f.values.front() == defined;
    const NodeId result = definition(f.variable, at->second->operands[1], same == positive);
    return same ? result : diagrams_.negation(result);
  }

  NodeId definition(VariableId variable, const Formula& f, bool positive) {
    if (const auto known = built_.find({variable, positive}); known != built_.end()) return known->second;
    const NodeId result = diagram_of(f, positive);
    built_.emplace(std::pair{variable, positive}, result);
    return result;
  }

  NodeId mode(ComponentId component, const std::vector<ValueId>& values, bool positive) {
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
      return holds(ModeId(static_cast<std::size_t>(start - initial.begin()))) ? Diagrams::one : Diagrams::zero;
    }
    const BasicEvent& event = tree_.events[*at->second];
    // What is neither failed nor as it started is sound too; a formula that tells the two apart sees the first step.
    const bool failed = holds(event.fault.mode);
    bool sound = holds(event.from);
    for (const Transition& t : plant_[component].transitions) {
      if (t.to != event.fault.mode && holds(t.to) != sound) throw Dynamic{};
    }
    if (failed == sound) return failed ? Diagrams::one : Diagrams::zero;
    const NodeId variable = diagrams_.variable(*at->second);
    if (failed != positive) tree_.monotone = false;
    return failed ? variable : diagrams_.negation(variable);
  }

  const Plant& plant_;
  Diagrams& diagrams_;
  std::map<VariableId, const Formula*> definitions_;
  std::map<VariableId, int> order_;  ///< 1: being looked at, 2: leads to no loop
  std::map<std::pair<VariableId, bool>, NodeId> built_;
  std::map<ComponentId, std::optional<std::uint32_t>> variables_;
  StaticTree tree_;
};

}  // namespace

std::optional<StaticTree> static_tree(const Plant& plant, const Formula& formula, Diagrams& diagrams) {
  try {
    return Builder(plant, diagrams).run(formula);
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
