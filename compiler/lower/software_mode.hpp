// Modes of software by what they tell: scenarios speak in the words of its program.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/plant.hpp"
#include "compiler/lower/part.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// Which modes may be meant: those that software may start in, or its fault modes.
enum class SoftwareMoment { start, fault };

/// Modes of software that tell the value of a variable, as a conjunct of their own. Of faults rather those whose
/// marking only improbable draws lead to.
std::vector<automata::Assignment> modes_that_tell(const automata::Plant& plant, automata::Assignment told,
                                                  SoftwareMoment moment);

/// Says that several modes tell it, and one is expected.
void report_several(const Part& part, automata::Assignment told, const std::vector<automata::Assignment>& telling,
                    grammar::Span span, grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
