// A configuration goal, taken apart into its conjuncts.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/goal.hpp"

#include <algorithm>

namespace rmpl::runtime {

using automata::Formula;

Goal::Goal(const Formula& formula, const automata::Plant& plant, automata::Theory& theory)
    : formula_(formula), named_(named_modes(plant, formula)) {
  for (const auto& component : plant.components) permitted_.emplace_back(component.modes.size(), true);
  std::vector<Formula> rest;
  for (Formula& conjunct : conjuncts_of(formula)) {
    if (conjunct.is_true()) continue;
    const auto component =
        conjunct.kind == Formula::Kind::member ? plant.component_of(conjunct.variable) : std::nullopt;
    if (!component) {
      rest.push_back(std::move(conjunct));
      continue;
    }
    auto& permitted = permitted_[component->index()];
    for (std::size_t m = 0; m < permitted.size(); ++m) {
      permitted[m] =
          permitted[m] && std::binary_search(conjunct.values.begin(), conjunct.values.end(), automata::ValueId(m));
    }
  }
  if (rest.empty()) return;
  Formula whole = automata::conjunction(std::move(rest));
  rest_ = Rest{theory.encode(whole), theory.encode(negation(whole)), std::move(whole)};
}

}  // namespace rmpl::runtime
