// Which commands are free in a step of a model program.
// SPDX-License-Identifier: MIT
#include "verifier/marking/commands.hpp"

#include <string>
#include <utility>

#include "automata/step/model_commands.hpp"
#include "base/limit_error.hpp"

namespace rmpl::verifier {

using automata::Command;

std::vector<Command> free_commands(const automata::ModelProgram& program, Commands commands) {
  constexpr std::size_t most_commands = std::size_t{1} << 16;
  if (commands == Commands::any) {
    if (auto all = automata::all_commands(program, most_commands)) return std::move(*all);
    throw base::LimitError("--commands any: there are more than " + std::to_string(most_commands) +
                           " combinations of commands; expected --commands one");
  }
  std::vector<Command> result = automata::single_commands(program);
  if (commands == Commands::none) result.resize(1);
  return result;
}

}  // namespace rmpl::verifier
