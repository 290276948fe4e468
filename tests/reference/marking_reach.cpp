// Layer by layer, nothing left out.
// SPDX-License-Identifier: MIT
#include "tests/reference/marking_reach.hpp"

#include <algorithm>
#include <optional>

namespace rmpl::reference {

std::vector<MarkingLayer> marking_layers(const ModelProgramStep& step, const std::vector<Commands>& free,
                                         std::size_t steps) {
  const auto add = [](MarkingLayer& layer, const MarkedSet& marking, Reached reached) {
    const auto [known, fresh] = layer.try_emplace(marking, reached);
    known->second = std::min(known->second, reached);
  };
  const auto off_idle = [&](const Commands& commands) {
    std::size_t count = 0;
    for (const automata::CommandedVariable& control : step.program().controls) {
      std::optional<automata::ValueId> value;
      for (const automata::Assignment& known : commands) {
        if (known.variable == control.variable) value = known.value;
      }
      count += value != control.idle ? 1 : 0;
    }
    return count;
  };
  std::vector<MarkingLayer> result(steps + 1);
  step.for_each_start([&](const MarkedSet& start, double, unsigned improbable) {
    add(result[0], start, {improbable, 0});
  });
  for (std::size_t s = 0; s < steps; ++s) {
    for (const auto& reached : result[s]) {
      for (const Commands& commands : free) {
        step.for_each_next(reached.first, commands, [&](const MarkedSet& next, double, unsigned improbable) {
          add(result[s + 1], next,
              {reached.second.improbable + improbable, reached.second.commanded + off_idle(commands)});
        });
      }
    }
  }
  return result;
}

}  // namespace rmpl::reference
