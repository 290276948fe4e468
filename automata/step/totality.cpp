// Islands that nothing contradicts, by elimination of attributes.
// SPDX-License-Identifier: MIT
#include "automata/step/totality.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "automata/logic/theory.hpp"

namespace automata {
namespace {

/// So many combinations of values are tried one by one; beyond that a solver is asked.
constexpr std::size_t most_combinations = 1u << 10;

/// The formula with a variable fixed.
Formula fixed(const Formula& formula, VariableId variable, ValueId value) {
  switch (formula.kind) {
    case Formula::Kind::member:
      if (formula.variable != variable) return formula;
      return constant(std::binary_search(formula.values.begin(), formula.values.end(), value));
    case Formula::Kind::equality:
      if (formula.variable == variable && formula.other == variable) return constant(true);
      if (formula.variable == variable) return is(formula.other, value);
      if (formula.other == variable) return is(formula.variable, value);
      return formula;
    default: {
      Formula result = formula;
      for (Formula& operand : result.operands) operand = fixed(operand, variable, value);
      return result;
    }
  }
}

class Elimination {
 public:
  Elimination(const Plant& plant, const Locality::Island& island) : plant_(plant) {
    for (const Locality::Constraint& told : island.constraints) {
      for (const Formula& conjunct : conjuncts_of(told.formula)) {
        const Formula whole =
            told.under ? implication(is(told.under->variable, told.under->value), conjunct) : conjunct;
        left_.insert(told_.size());
        told_.push_back({whole, variables_of(whole)});
      }
    }
    for (const VariableId attribute : island.attributes) {
      const bool control = std::any_of(plant.controls.begin(), plant.controls.end(),
                                       [&](const Control& c) { return c.variable == attribute; });
      if (!control) readers_.try_emplace(attribute);
    }
    for (std::size_t t = 0; t < told_.size(); ++t) {
      for (const VariableId v : told_[t].variables) {
        if (const auto at = readers_.find(v); at != readers_.end()) at->second.insert(t);
      }
    }
    for (const auto& [attribute, readers] : readers_) open_.emplace(readers.size(), attribute);
  }

  bool succeeds() {
    // What few constraints read is quick to judge, and effects are read by few. What cannot go is looked at again when
    // something that reads it has gone.
    while (!left_.empty() && !open_.empty()) {
      const VariableId attribute = open_.begin()->second;
      open_.erase(open_.begin());
      if (!always_has_a_value(attribute)) continue;
      const std::set<std::size_t> gone = std::move(readers_.at(attribute));
      readers_.erase(attribute);
      for (const std::size_t t : gone) take_away(t);
    }
    return left_.empty();
  }

 private:
  struct Told {
    Formula formula;
    std::vector<VariableId> variables;
  };

  void take_away(std::size_t told) {
    left_.erase(told);
    for (const VariableId v : told_[told].variables) {
      const auto at = readers_.find(v);
      if (at == readers_.end()) continue;
      open_.erase({at->second.size(), v});
      at->second.erase(told);
      open_.emplace(at->second.size(), v);
    }
  }

  [[nodiscard]] std::size_t values_of(VariableId variable) const { return plant_.variables[variable].values.size(); }

  [[nodiscard]] bool always_has_a_value(VariableId attribute) const {
    std::vector<VariableId> others;
    std::vector<Formula> all;
    for (const std::size_t t : readers_.at(attribute)) {
      others.insert(others.end(), told_[t].variables.begin(), told_[t].variables.end());
      all.push_back(told_[t].formula);
    }
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    std::erase(others, attribute);
    std::vector<Formula> contradicted;
    for (std::size_t v = 0; v < values_of(attribute); ++v) {
      contradicted.push_back(negation(fixed(conjunction(all), attribute, ValueId(v))));
    }
    return !satisfiable(conjunction(std::move(contradicted)), others);
  }

  /// Whether some values of the variables make the formula true; it reads no others.
  [[nodiscard]] bool satisfiable(const Formula& formula, const std::vector<VariableId>& variables) const {
    const auto position = [&](VariableId variable) {
      return static_cast<std::size_t>(std::lower_bound(variables.begin(), variables.end(), variable) -
                                      variables.begin());
    };
    std::size_t combinations = 1;
    for (const VariableId v : variables) combinations = std::min(combinations * values_of(v), most_combinations + 1);
    if (combinations > most_combinations) {
      Variables own;
      for (const VariableId v : variables) own.add(plant_.variables[v]);
      Theory theory(own);
      const auto handle = theory.encode(renamed(
          formula, [&](VariableId v) { return VariableId(position(v)); }, [](VariableId, ValueId v) { return v; }));
      return theory.allows({}, handle);
    }
    std::vector<ValueId> values(variables.size(), ValueId(0));
    for (std::size_t i = 0; i < combinations; ++i) {
      if (evaluate(formula, [&](VariableId v) { return values[position(v)]; })) return true;
      for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] = ValueId(values[k].index() + 1);
        if (values[k].index() < values_of(variables[k])) break;
        values[k] = ValueId(0);
      }
    }
    return false;
  }

  const Plant& plant_;
  std::vector<Told> told_;
  std::set<std::size_t> left_;                           ///< of those, which have not gone
  std::map<VariableId, std::set<std::size_t>> readers_;  ///< of the attributes that have not gone
  std::set<std::pair<std::size_t, VariableId>> open_;    ///< number of readers, attribute: not looked at since
};

}  // namespace

bool is_total(const Plant& plant, const Locality::Island& island) { return Elimination(plant, island).succeeds(); }

}  // namespace automata
