// Modes, control actions, observations: conversions.
// SPDX-License-Identifier: MIT
#include "automata/state.hpp"

#include <algorithm>
#include <optional>

#include "automata/controls.hpp"
#include "base/error.hpp"

namespace rmpl::automata {

ControlAction idle_action(const Plant& plant) {
  ControlAction action;
  action.reserve(plant.controls.size());
  for (const Control& control : plant.controls) action.push_back(control.idle);
  return action;
}

std::vector<Assignment> commanded(const Plant& plant, const ControlAction& action) {
  std::vector<Assignment> off_idle;
  for (std::size_t i = 0; i < action.size(); ++i) {
    if (action[i] != plant.controls[i].idle) off_idle.push_back({plant.controls[i].variable, action[i]});
  }
  return off_idle;
}

std::vector<Assignment> assignments_of(const Plant& plant, const ControlAction& action) {
  std::vector<Assignment> all;
  all.reserve(action.size());
  for (std::size_t i = 0; i < action.size(); ++i) all.push_back({plant.controls[i].variable, action[i]});
  return all;
}

std::vector<Assignment> assignments_of(const Plant& plant, const Modes& modes) {
  std::vector<Assignment> all;
  all.reserve(modes.size());
  append_known(plant, modes, all);
  return all;
}

void append_known(const Plant& plant, const Modes& modes, std::vector<Assignment>& assignments) {
  for (std::size_t i = 0; i < plant.components.size(); ++i) {
    assignments.push_back({plant.components[i].mode, ValueId(modes[i].index())});
  }
}

ControlAction action_from(const Plant& plant, std::span<const Assignment> assignments) {
  ControlAction action = idle_action(plant);
  constexpr std::size_t few = 16;  // for which the list of controls is gone through
  std::vector<std::optional<std::size_t>> by_variable;
  if (assignments.size() > few) {
    by_variable.resize(plant.variables.size());
    for (std::size_t i = 0; i < plant.controls.size(); ++i) by_variable[plant.controls[i].variable.index()] = i;
  }
  for (const Assignment& a : assignments) {
    const auto at = by_variable.empty() ? control_of(plant, a.variable) : by_variable[a.variable.index()];
    if (!at) {
      throw base::InputError("'" + plant.variables.name(a.variable) + "' is no control variable of plant '" +
                             plant.name + "'");
    }
    action[*at] = a.value;
  }
  return action;
}

std::size_t ModesHash::operator()(const Modes& modes) const noexcept {
  std::size_t hash = 0xcbf29ce484222325u;
  for (const ModeId mode : modes) hash = (hash ^ mode.value) * 0x100000001b3u;
  return hash;
}

}  // namespace rmpl::automata
