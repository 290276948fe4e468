// What a model program can come to, by enumeration: the twin of a check of its threads as components.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "tests/reference/model_program.hpp"

namespace rmpl::reference {

/// How a marking is reached: as few draws as can be, and with these as few values off idle.
struct Reached {
  unsigned improbable = 0;
  std::size_t commanded = 0;
  auto operator<=>(const Reached&) const = default;
};
/// Of each marking that is reached in just so many steps.
using MarkingLayer = std::map<MarkedSet, Reached>;

/// Layers 0 to `steps`: every draw of every location under every one of the commands, one combination after the other.
std::vector<MarkingLayer> marking_layers(const ModelProgramStep& step, const std::vector<Commands>& free,
                                         std::size_t steps);

}  // namespace rmpl::reference
