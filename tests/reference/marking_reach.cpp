// Layer by layer, nothing left out.
// SPDX-License-Identifier: MIT
#include "tests/reference/marking_reach.hpp"

#include <algorithm>

namespace rmpl::reference {

std::vector<MarkingLayer> marking_layers(const ModelProgramStep& step, const std::vector<Commands>& free,
                                         std::size_t steps) {
  const auto add = [](MarkingLayer& layer, const MarkedSet& marking, unsigned improbable) {
    const auto [known, fresh] = layer.try_emplace(marking, improbable);
    known->second = std::min(known->second, improbable);
  };
  std::vector<MarkingLayer> result(steps + 1);
  step.for_each_start([&](const MarkedSet& start, double, unsigned improbable) { add(result[0], start, improbable); });
  for (std::size_t s = 0; s < steps; ++s) {
    for (const auto& reached : result[s]) {
      for (const Commands& commands : free) {
        step.for_each_next(reached.first, commands, [&](const MarkedSet& next, double, unsigned improbable) {
          add(result[s + 1], next, reached.second + improbable);
        });
      }
    }
  }
  return result;
}

}  // namespace rmpl::reference
