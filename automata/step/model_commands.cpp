// Controls one by one, or multiplied out.
// SPDX-License-Identifier: MIT
#include "automata/step/model_commands.hpp"

#include "base/product.hpp"

namespace rmpl::automata {
namespace {

/// Per control: idle, then the others.
std::vector<std::vector<std::optional<ValueId>>> values_of(const ModelProgram& program) {
  std::vector<std::vector<std::optional<ValueId>>> result;
  for (const CommandedVariable& control : program.controls) {
    auto& own = result.emplace_back();
    own.push_back(control.idle);
    for (std::size_t value = 0; value < program.variables[control.variable].values.size(); ++value) {
      if (control.idle != ValueId(value)) own.emplace_back(ValueId(value));
    }
  }
  return result;
}

}  // namespace

std::vector<Command> single_commands(const ModelProgram& program) {
  const auto values = values_of(program);
  Command idle;
  for (const auto& own : values) idle.push_back(own.front());
  std::vector<Command> result{idle};
  for (std::size_t c = 0; c < values.size(); ++c) {
    for (std::size_t value = 1; value < values[c].size(); ++value) {
      result.push_back(idle);
      result.back()[c] = values[c][value];
    }
  }
  return result;
}

std::optional<std::vector<Command>> all_commands(const ModelProgram& program, std::size_t most) {
  const auto values = values_of(program);
  std::size_t combinations = 1;
  for (const auto& own : values) {
    combinations *= own.size();
    if (combinations > most) return std::nullopt;
  }
  std::vector<Command> result;
  result.reserve(combinations);
  base::for_each_combination(values, [&](const Command& command) { result.push_back(command); });
  return result;
}

}  // namespace rmpl::automata
