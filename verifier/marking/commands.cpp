// Which commands are free in a step of a model program.
// SPDX-License-Identifier: MIT
#include "verifier/marking/commands.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "base/limit_error.hpp"
#include "base/product.hpp"

namespace rmpl::verifier {

using automata::Command;
using automata::CommandedVariable;
using automata::ValueId;

namespace {

constexpr std::size_t most_commands = std::size_t{1} << 16;

/// Idle, then the others.
std::vector<std::optional<ValueId>> values_of(const automata::ModelProgram& program, const CommandedVariable& control) {
  std::vector<std::optional<ValueId>> result{control.idle};
  for (std::size_t value = 0; value < program.variables[control.variable].values.size(); ++value) {
    if (control.idle != ValueId(value)) result.emplace_back(ValueId(value));
  }
  return result;
}

}  // namespace

std::vector<Command> free_commands(const automata::ModelProgram& program, Commands commands) {
  std::vector<std::vector<std::optional<ValueId>>> values;
  Command idle;
  for (const CommandedVariable& control : program.controls) {
    values.push_back(values_of(program, control));
    idle.push_back(control.idle);
  }
  std::vector<Command> result;
  if (commands == Commands::any) {
    base::for_each_combination(values, [&](const Command& command) {
      if (result.size() == most_commands) {
        throw base::LimitError("--commands any: there are more than " + std::to_string(most_commands) +
                               " combinations of commands; expected --commands one");
      }
      result.push_back(command);
    });
    return result;
  }
  result.push_back(idle);
  if (commands == Commands::none) return result;
  for (std::size_t c = 0; c < values.size(); ++c) {
    for (std::size_t value = 1; value < values[c].size(); ++value) {
      result.push_back(idle);
      result.back()[c] = values[c][value];
    }
  }
  return result;
}

}  // namespace rmpl::verifier
