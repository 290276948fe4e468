// Which control actions are free to be taken in a step.
// SPDX-License-Identifier: MIT
#include "verifier/property/commands.hpp"

namespace rmpl::verifier {

using automata::ControlAction;
using automata::Plant;
using automata::ValueId;

namespace {

std::size_t values_of(const Plant& plant, std::size_t control) {
  return plant.variables[plant.controls[control].variable].values.size();
}

/// Idle first, then combinations like the readings of a counter whose last digit is the last control.
void for_each_combination(const Plant& plant, base::FunctionRef<void(const ControlAction&)> visit) {
  const ControlAction idle = automata::idle_action(plant);
  visit(idle);
  ControlAction action(plant.controls.size(), ValueId(0));
  while (true) {
    if (action != idle) visit(action);
    std::size_t digit = action.size();
    while (digit > 0 && action[digit - 1].index() + 1 == values_of(plant, digit - 1)) action[--digit] = ValueId(0);
    if (digit == 0) return;
    action[digit - 1] = ValueId(action[digit - 1].index() + 1);
  }
}

}  // namespace

void for_each_action(const Plant& plant, Commands commands, base::FunctionRef<void(const ControlAction&)> visit) {
  if (commands == Commands::any) return for_each_combination(plant, visit);
  ControlAction action = automata::idle_action(plant);
  visit(action);
  if (commands == Commands::none) return;
  for (std::size_t control = 0; control < plant.controls.size(); ++control) {
    const ValueId idle = plant.controls[control].idle;
    for (std::size_t value = 0; value < values_of(plant, control); ++value) {
      action[control] = ValueId(value);
      if (action[control] != idle) visit(action);
    }
    action[control] = idle;
  }
}

bool permits(Commands commands, std::size_t off_idle) {
  switch (commands) {
    case Commands::none:
      return off_idle == 0;
    case Commands::one:
      return off_idle <= 1;
    case Commands::any:
      return true;
  }
  return false;
}

bool is_free(const Plant& plant, Commands commands, const ControlAction& action) {
  return permits(commands, automata::commanded(plant, action).size());
}

}  // namespace rmpl::verifier
