// What is asked of another tool.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/state.hpp"
#include "verifier/property/commands.hpp"

namespace rmpl::verifier {

/// Can the target be reached.
struct ExportQuestion {
  automata::Formula target;
  bool entailed = false;
  unsigned faults = 0;
  Commands commands = Commands::one;
  std::vector<automata::Assignment> from;  ///< modes, in place of the initial distribution
};

}  // namespace rmpl::verifier
