// Estimation of a model program behind the interface of plants, so that an executive can fly it.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "automata/step/marked_plant.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/marking/marking_estimator.hpp"

namespace rmpl::runtime {

/// States are those of `plant`, without clocks: what a marking entails, and the marking. The estimate is the likeliest
/// marking; the belief lists what `options` keep, each marking once. No rivals of a diagnosis are told. Keeps
/// references to both. Throws base::InputError where no start is consistent.
std::unique_ptr<Estimator> make_marked_estimator(const automata::ModelProgram& program,
                                                 const automata::MarkedPlant& plant, const MarkingOptions& options);

}  // namespace rmpl::runtime
