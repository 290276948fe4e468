// Markings as modes, and back.
// SPDX-License-Identifier: MIT
#include "automata/step/marked_plant.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "automata/facade.hpp"

namespace rmpl::automata {

MarkedPlant::MarkedPlant(const ModelProgram& program)
    : plant_(facade_of(program)), shown_(plant_.components.size()), at_(program.locations.size()) {
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    const ModelLocation& location = program.locations[l];
    if (location.composite) continue;
    Component component;
    component.name = "location " + std::to_string(l + 1);  // no identifier: it clashes with none
    component.mode = plant_.variables.add({component.name, {"no", "yes"}});
    component.modes.resize(2);
    component.modes[0].name = "no";
    component.modes[1].name = "yes";
    component.modes[1].constraint = location.told;
    component.origin = location.origin;
    at_[l] = plant_.components.size();
    primitive_.emplace_back(l);
    plant_.components.push_back(std::move(component));
  }
}

Modes MarkedPlant::modes(const Marking& marking, std::span<const Assignment> values) const {
  Modes modes(plant_.components.size(), ModeId(0));
  for (std::size_t c = 0; c < shown_; ++c) {
    const Component& component = plant_.components[c];
    const auto value = std::lower_bound(values.begin(), values.end(), component.mode,
                                        [](const Assignment& a, VariableId v) { return a.variable < v; });
    const bool entailed = value != values.end() && value->variable == component.mode;
    modes[c] = ModeId(entailed ? value->value.index() : component.modes.size() - 1);
  }
  for (const LocationId location : marking) {
    if (at_[location.index()]) modes[*at_[location.index()]] = ModeId(1);
  }
  return modes;
}

Marking MarkedPlant::marking(const Modes& modes) const {
  Marking result;
  for (std::size_t p = 0; p < primitive_.size(); ++p) {
    if (modes[shown_ + p].index() == 1) result.push_back(primitive_[p]);
  }
  return result;
}

Command command_of(const ControlAction& action) { return {action.begin(), action.end()}; }

}  // namespace rmpl::automata
