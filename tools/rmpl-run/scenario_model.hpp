// rmpl-run scenario of a model program: a list of commands, and what is drawn under them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "automata/phca.hpp"
#include "tools/shared/options.hpp"

namespace rmpl::tools {

/// Prints a log: time 0, then each line of the list with the readings, the marking and what it entails. Throws
/// base::InputError, before anything is printed, where an input is wrong or nothing can follow.
ExitStatus fly_model(const automata::ModelProgram& program, const std::string& paths, const std::string& commands,
                     std::uint64_t seed);

}  // namespace rmpl::tools
