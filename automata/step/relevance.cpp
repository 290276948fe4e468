// Attributes that make no difference, one after the other.
// SPDX-License-Identifier: MIT
#include "automata/step/relevance.hpp"

#include <algorithm>

namespace automata {
namespace {

/// Up to so many combinations of the values of its neighbours an attribute is looked at.
constexpr std::size_t most_combinations = 1u << 12;

/// A conjunct of Q, or of a mode's constraint, then under that mode.
struct Constraint {
  std::optional<Assignment> under;
  Formula formula;
  std::vector<VariableId> variables;
  bool dropped = false;
};

class Elimination {
 public:
  explicit Elimination(const Plant& plant)
      : plant_(plant),
        values_(plant.variables.size()),
        readers_(plant.variables.size()),
        kept_(plant.variables.size()) {
    for (const Formula& q : plant.interconnections) add(std::nullopt, q);
    for (const Component& component : plant.components) {
      kept_[component.mode.index()] = true;
      for (std::size_t m = 0; m < component.modes.size(); ++m) {
        add(Assignment{component.mode, ValueId(m)}, component.modes[m].constraint);
      }
      for (const Transition& t : component.transitions) {
        for (const VariableId v : variables_of(t.guard)) kept_[v.index()] = true;
      }
    }
    for (const Control& control : plant.controls) kept_[control.variable.index()] = true;
  }

  Plant run() {
    // What is left out may free its neighbours.
    for (bool dropped = true; dropped;) {
      dropped = false;
      for (std::size_t v = 0; v < kept_.size(); ++v) {
        if (kept_[v] || left_out(VariableId(v)) || !suits_all(VariableId(v))) continue;
        for (const std::size_t reader : readers_[v]) constraints_[reader].dropped = true;
        left_out_.push_back(VariableId(v));
        dropped = true;
      }
    }
    return result();
  }

 private:
  void add(std::optional<Assignment> under, const Formula& formula) {
    for (Formula& conjunct : conjuncts_of(formula)) {
      auto variables = variables_of(conjunct);
      for (const VariableId v : variables) readers_[v.index()].push_back(constraints_.size());
      if (under && !std::binary_search(variables.begin(), variables.end(), under->variable)) {
        variables.push_back(under->variable);
      }
      constraints_.push_back({under, std::move(conjunct), std::move(variables)});
    }
  }

  [[nodiscard]] bool left_out(VariableId variable) const {
    return std::find(left_out_.begin(), left_out_.end(), variable) != left_out_.end();
  }

  /// Whether each combination of the neighbours' values leaves the attribute some value.
  bool suits_all(VariableId attribute) {
    std::vector<const Constraint*> constraints;
    std::vector<VariableId> neighbours;
    for (const std::size_t reader : readers_[attribute.index()]) {
      const Constraint& constraint = constraints_[reader];
      if (constraint.dropped) continue;
      constraints.push_back(&constraint);
      for (const VariableId v : constraint.variables) {
        if (v != attribute && std::find(neighbours.begin(), neighbours.end(), v) == neighbours.end()) {
          neighbours.push_back(v);
        }
      }
    }
    std::size_t combinations = 1;
    for (const VariableId v : neighbours) {
      combinations = std::min(combinations * size(v), most_combinations + 1);
      values_[v.index()] = ValueId(0);
    }
    if (combinations > most_combinations) return false;
    while (true) {
      if (!some_value(attribute, constraints)) return false;
      std::size_t i = 0;
      for (; i < neighbours.size(); ++i) {
        ValueId& value = values_[neighbours[i].index()];
        value = ValueId(value.index() + 1);
        if (value.index() < size(neighbours[i])) break;
        value = ValueId(0);
      }
      if (i == neighbours.size()) return true;
    }
  }

  bool some_value(VariableId attribute, const std::vector<const Constraint*>& constraints) {
    const auto value_of = [this](VariableId v) { return values_[v.index()]; };
    for (std::size_t value = 0; value < size(attribute); ++value) {
      values_[attribute.index()] = ValueId(value);
      const bool suits = std::all_of(constraints.begin(), constraints.end(), [&](const Constraint* c) {
        return (c->under && values_[c->under->variable.index()] != c->under->value) || evaluate(c->formula, value_of);
      });
      if (suits) return true;
    }
    return false;
  }

  [[nodiscard]] Plant result() const {
    Plant part = plant_;
    part.variables = {};
    for (std::size_t v = 0; v < plant_.variables.size(); ++v) {
      Variable variable = plant_.variables[VariableId(v)];
      if (left_out(VariableId(v))) variable.values.resize(1);
      part.variables.add(std::move(variable));
    }
    std::erase_if(part.observables, [this](VariableId v) { return left_out(v); });
    std::vector<Formula> interconnections;
    std::vector<std::vector<std::vector<Formula>>> by_mode;
    for (const Component& component : plant_.components) by_mode.emplace_back(component.modes.size());
    for (const Constraint& c : constraints_) {
      if (c.dropped) continue;
      auto& into =
          c.under ? by_mode[plant_.component_of(c.under->variable)->index()][c.under->value.index()] : interconnections;
      into.push_back(c.formula);
    }
    part.interconnections = std::move(interconnections);
    for (std::size_t c = 0; c < by_mode.size(); ++c) {
      for (std::size_t m = 0; m < by_mode[c].size(); ++m) {
        part.components[c].modes[m].constraint = conjunction(std::move(by_mode[c][m]));
      }
    }
    return part;
  }

  [[nodiscard]] std::size_t size(VariableId variable) const { return plant_.variables[variable].values.size(); }

  const Plant& plant_;
  std::vector<Constraint> constraints_;
  std::vector<ValueId> values_;
  std::vector<std::vector<std::size_t>> readers_;  ///< per variable
  std::vector<bool> kept_;                         ///< per variable: a mode, a control, or what a guard reads
  std::vector<VariableId> left_out_;
};

}  // namespace

Plant relevant_part(const Plant& plant) { return Elimination(plant).run(); }

}  // namespace automata
