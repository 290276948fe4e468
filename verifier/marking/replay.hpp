// Replaying a run of a model program on the rules of semantics 8, apart from all that found it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "verifier/marking/question.hpp"

namespace rmpl::verifier {

/// Why the run is not possible, or does not answer the question; nothing where it is and does. `improbable`: the draws
/// of the whole run that are claimed to be enough. On the way the draws of each event are filled in. Draws are tried
/// out location by location as the paper defines a step, without what the search knows of parts and what is certain.
std::optional<std::string> replay(const automata::ModelProgram& program, const MarkingQuestion& question,
                                  unsigned improbable, MarkingWitness& witness);

}  // namespace rmpl::verifier
