// Connectives without constants.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/logic/formula.hpp"

namespace rmpl::automata {

/// Rebuilds a connective over operands that may have become constants: none of these is left below it.
Formula folded(Formula::Kind kind, std::vector<Formula> operands);

}  // namespace rmpl::automata
