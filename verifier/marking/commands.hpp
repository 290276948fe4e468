// Which commands are free in a step of a model program.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/step/marking_store.hpp"
#include "verifier/property/commands.hpp"

namespace rmpl::verifier {

/// Every free command, each once: first idle (unknown, where a control has no default), then in declaration order of
/// controls and values. Throws base::LimitError where they are too many to be listed.
std::vector<automata::Command> free_commands(const automata::ModelProgram& program, Commands commands);

}  // namespace rmpl::verifier
