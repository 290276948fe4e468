// What no run can come to.
// SPDX-License-Identifier: MIT
#include "verifier/check/out_of_reach.hpp"

#include <algorithm>
#include <climits>
#include <utility>

#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using automata::Component;
using automata::Formula;
using automata::ModeId;

namespace {

/// The modes that a component can come to from these with so many faults, ascending.
std::vector<automata::ValueId> within_reach(const Component& component, const std::vector<ModeId>& start,
                                            unsigned faults) {
  constexpr unsigned never = UINT_MAX;
  std::vector<unsigned> needed(component.modes.size(), never);
  for (const ModeId m : start) needed[m.index()] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const automata::Transition& t : component.transitions) {
      if (t.from == t.to || needed[t.from.index()] == never) continue;
      const unsigned cost = needed[t.from.index()] + (component.is_fault(t) ? 1 : 0);
      changed = changed || cost < needed[t.to.index()];
      needed[t.to.index()] = std::min(needed[t.to.index()], cost);
    }
  }
  std::vector<automata::ValueId> result;
  for (std::size_t m = 0; m < needed.size(); ++m) {
    if (needed[m] != never && needed[m] <= faults) result.emplace_back(m);
  }
  return result;
}

}  // namespace

bool out_of_reach(automata::PlantStep& step, const Formula& formula, const std::vector<automata::Assignment>& from,
                  unsigned faults) {
  const automata::Plant& plant = step.plant();
  const std::vector<std::vector<ModeId>> start = initial_modes(plant, from);
  std::vector<Formula> all = {formula};
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const Component& component = plant.components[c];
    std::vector<automata::ValueId> modes = within_reach(component, start[c], faults);
    if (modes.size() < component.modes.size()) all.push_back(automata::member(component.mode, std::move(modes)));
  }
  return !step.theory().allows({}, step.theory().encode(automata::conjunction(std::move(all))));
}

}  // namespace rmpl::verifier
