// What a model program can come to, by enumeration: the twin of verifier/marking.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "tests/reference/model_program.hpp"

namespace rmpl::reference {

/// The fewest improbable draws with which each marking is reached in just so many steps.
using MarkingLayer = std::map<MarkedSet, unsigned>;

/// Layers 0 to `steps`: every draw of every location under every one of the commands, one combination after the other.
std::vector<MarkingLayer> marking_layers(const ModelProgramStep& step, const std::vector<Commands>& free,
                                         std::size_t steps);

}  // namespace rmpl::reference
