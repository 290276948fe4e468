// Clocks that are read where no path has started them (language.md: "reading one that no path starts is an error").
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/check/definitions.hpp"
#include "compiler/check/recursion.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// Reports each read of a clock that no path from a root has started: not before it, not in a parallel thread, not in
/// an earlier turn of a loop around it; for a clock of a definition's own, in
/// the definition itself. Each definition is summed up once, callees first, so the cost is that of the
/// text (times the depth of calls, where each level has clocks of its own).
void check_clocks(const Definitions& definitions, const Recursion& recursion, const std::vector<std::size_t>& roots,
                  grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
