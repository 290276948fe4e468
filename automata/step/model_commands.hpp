// The commands that a step of a model program may be given.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "automata/phca.hpp"
#include "automata/step/marking_store.hpp"

namespace rmpl::automata {

/// Idle (unknown, where a control has no default); then one control off that, in declaration order of controls and
/// values.
std::vector<Command> single_commands(const ModelProgram& program);

/// Every combination, the first control outermost, of each the idle value first; nothing where they are more than
/// `most`.
std::optional<std::vector<Command>> all_commands(const ModelProgram& program, std::size_t most);

}  // namespace rmpl::automata
