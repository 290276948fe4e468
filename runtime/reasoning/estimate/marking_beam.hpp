// The paper's own estimator, RMPL-ME: a beam of whole markings (ijcai01, "Estimation as beam search").
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "runtime/reasoning/estimate/marking_estimator.hpp"

namespace rmpl::runtime {

/// Among the markings that the readings leave possible the `k` of greatest *predicted* probability are kept; the
/// observation factor is applied after that. Keeps a reference to the program.
std::unique_ptr<MarkingEstimator> make_marking_beam(const automata::ModelProgram& program,
                                                    const MarkingOptions& options);

}  // namespace rmpl::runtime
