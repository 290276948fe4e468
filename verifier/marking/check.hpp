// Checking a model program: what it can come to, and what never holds of it.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/marking/question.hpp"

namespace rmpl::verifier {

/// Every witness has been replayed. Throws base::LimitError where the ways of one step, or the commands, are too many
/// to be told apart.
MarkingAnswer check(const automata::ModelProgram& program, const MarkingQuestion& question, const Limits& limits);

}  // namespace rmpl::verifier
