// Preconditions as sets of what fits them.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/nominal/precondition.hpp"

#include <algorithm>
#include <iterator>

namespace rmpl::runtime {

using automata::Formula;
using automata::Plant;
using automata::ValueId;
using automata::VariableId;

std::size_t commanded_controls(const Plant& plant, const automata::PlantIndex& index,
                               const Precondition& precondition) {
  return static_cast<std::size_t>(std::count_if(precondition.begin(), precondition.end(), [&](const Requirement& r) {
    const auto control = index.control_of(r.variable);
    return control && !std::binary_search(r.values.begin(), r.values.end(), plant.controls[*control].idle);
  }));
}

Formula formula_of(const Precondition& precondition) {
  std::vector<Formula> parts;
  for (const Requirement& r : precondition) parts.push_back(member(r.variable, r.values));
  return automata::conjunction(std::move(parts));
}

bool subsumes(const Precondition& wide, const Precondition& narrow) {
  return std::all_of(wide.begin(), wide.end(), [&](const Requirement& r) {
    const auto at = std::lower_bound(narrow.begin(), narrow.end(), r.variable,
                                     [](const Requirement& n, VariableId v) { return n.variable < v; });
    return at != narrow.end() && at->variable == r.variable &&
           std::includes(r.values.begin(), r.values.end(), at->values.begin(), at->values.end());
  });
}

std::optional<Precondition> both(const Precondition& left, const Precondition& right) {
  Precondition result = left;
  for (const Requirement& r : right) {
    const auto at = std::lower_bound(result.begin(), result.end(), r.variable,
                                     [](const Requirement& n, VariableId v) { return n.variable < v; });
    if (at == result.end() || at->variable != r.variable) {
      result.insert(at, r);
      continue;
    }
    std::vector<ValueId> values;
    std::set_intersection(at->values.begin(), at->values.end(), r.values.begin(), r.values.end(),
                          std::back_inserter(values));
    if (values.empty()) return std::nullopt;
    at->values = std::move(values);
  }
  return result;
}

bool needs_no_command(const Plant& plant, const automata::PlantIndex& index, const Precondition& precondition) {
  return commanded_controls(plant, index, precondition) == 0;
}

}  // namespace rmpl::runtime
