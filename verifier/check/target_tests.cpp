// How a search sees what is wanted.
// SPDX-License-Identifier: MIT
#include "verifier/check/target_tests.hpp"

#include <algorithm>
#include <memory>

#include "automata/dependencies/plant_index.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::Formula;
using automata::Modes;
using automata::PlantStep;
using automata::Theory;

automata::Support support_of(const PlantStep& step, const Formula& formula) {
  return {step.locality().support_of(formula).components, {}};
}

Observer::Test holds(PlantStep& step, const Formula& formula, bool certain) {
  // A possible state gives every mode a value: where nothing else is asked for, the store has nothing to add.
  const automata::PlantIndex index(step.plant());
  const std::vector<automata::VariableId> variables = automata::variables_of(formula);
  if (std::all_of(variables.begin(), variables.end(), [&](auto v) { return index.component_of(v).has_value(); })) {
    return [index, formula](const Modes& modes) {
      return automata::evaluate(formula, [&](automata::VariableId v) {
        return automata::ValueId(modes[index.component_of(v)->index()].index());
      });
    };
  }
  using Memory = automata::Memory<bool>;
  const automata::Support support = support_of(step, formula);
  const Theory::Handle handle = step.theory().encode(formula);
  const auto memory = std::make_shared<Memory>(step.plant(), support);
  return [&step, handle, certain, support, memory](const Modes& modes) {
    return memory->find(modes, automata::ControlAction{}, [&] {
      std::vector<Assignment> store;
      for (const automata::ComponentId c : support.components) {
        store.push_back({step.plant()[c].mode, automata::ValueId(modes[c.index()].index())});
      }
      return certain ? step.theory().entails(store, handle) : step.theory().allows(store, handle);
    });
  };
}

std::optional<std::vector<PathState>> any_path(PlantSystem& system, bool merge, Meter& meter) {
  if (merge) {
    const auto corridor = find_corridor(system, meter);
    if (!corridor) return std::nullopt;
    if (auto path = find_path_along(*corridor, system, meter)) return path;
  }
  return find_path(system, SearchOrder::covering, meter);
}

}  // namespace rmpl::verifier
