// What of the outcomes of markings can happen, where steps are products of parts (compare possible_share.hpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/step/marking_stages.hpp"
#include "automata/step/marking_step.hpp"

namespace rmpl::runtime {

/// By place in `begins`: the probability that what is marked after the step from there is consistent. From the ends
/// back to the beginnings. Throws TooManyOutcomes, as the stages do.
std::vector<double> possible_shares(automata::MarkingStages& stages, automata::MarkingStep& step,
                                    const std::vector<automata::MarkingStages::Place>& begins);

}  // namespace rmpl::runtime
