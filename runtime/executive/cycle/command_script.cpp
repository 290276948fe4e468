// Of several commands in force for a control, the one that began last counts.
// SPDX-License-Identifier: MIT
#include "runtime/executive/cycle/command_script.hpp"

#include <algorithm>

#include "automata/controls.hpp"

namespace rmpl::runtime {

CommandScript::CommandScript(const automata::Plant& plant, const automata::Scenario& scenario)
    : plant_(plant), commands_(scenario.commands) {
  std::stable_sort(commands_.begin(), commands_.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
}

void CommandScript::command(automata::ControlAction& action, automata::Ticks now) const {
  for (const automata::GivenCommand& given : commands_) {
    if (given.at > now) return;
    if (!given.duration.is_infinite() && now - given.at >= given.duration) continue;
    action[*automata::control_of(plant_, given.command.variable)] = given.command.value;
  }
}

}  // namespace rmpl::runtime
