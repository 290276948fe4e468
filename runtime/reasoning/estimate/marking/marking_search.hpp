// The best markings over several sources whose ways are too many to be listed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "runtime/reasoning/estimate/marking/marking_filter.hpp"

namespace rmpl::runtime {

/// What makes a marking good, of those that the readings leave possible.
enum class Worth {
  posterior,  ///< the predicted probability with the observation factor
  beam        ///< the predicted probability
};

struct BestMarkings {
  NumberedBelief found;  ///< with what each is worth, not normalised; more than were asked for, in no order
  double unfound = 0;    ///< at most so much is predicted of all others that count
  bool cut = false;
  std::size_t checked = 0;
};

/// The `k` markings of greatest worth over the sources, whose command and observation the step knows. One
/// conflict-directed search per source over the outcomes of its parts, taken in turns, best bound first: what a marking
/// is worth is summed over all sources when it is found first, and the search ends when all that is left of all sources
/// together is worth less than the k-th.
BestMarkings best_markings(automata::MarkingStep& step, const NumberedBelief& sources, Worth worth, std::size_t k,
                           std::size_t candidates);

}  // namespace rmpl::runtime
