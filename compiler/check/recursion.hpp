// Recursion among definitions: which is legal, and which calls are not (language.md "Control programs").
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <unordered_set>
#include <vector>

#include "compiler/check/definitions.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// The strongly connected sets of the call graph.
struct Recursion {
  std::vector<std::size_t> group;                 ///< per definition, the number of its set
  std::vector<std::vector<std::size_t>> members;  ///< per set, its definitions; callees come before callers
  std::vector<bool> recursive;                    ///< per set, whether its members call each other, or themselves
  /// Calls that may not be expanded: recursion that is an error. Without them, expansion ends.
  std::unordered_set<const grammar::Call*> cut;
};

/// Finds recursion (Tarjan's algorithm, linear). Reports each recursive call that is not the last thing that its
/// definition does, and each cycle of calls with no location between, naming the cycle.
Recursion check_recursion(const Definitions& definitions, grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
