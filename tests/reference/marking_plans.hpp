// The cheapest way to a goal in a model program, by enumeration: the twin of
// runtime/reasoning/reconfigure/marking_planner. SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "tests/reference/model_program.hpp"

namespace rmpl::reference {

/// Fewer steps first, then fewer values off idle.
struct PlanCost {
  std::size_t steps = 0;
  std::size_t busy = 0;
  auto operator<=>(const PlanCost&) const = default;
};

/// A command that is free in every step, with how many of its values are off idle.
struct FreeCommand {
  Commands values;
  std::size_t busy = 0;
};

/// From a marking to one that entails all of `goal`, by draws that are not improbable; nothing where no way takes at
/// most `most` steps.
std::optional<PlanCost> cheapest(const ModelProgramStep& step, const std::vector<FreeCommand>& free,
                                 const MarkedSet& from, const std::vector<automata::Assignment>& goal,
                                 std::size_t most);

}  // namespace rmpl::reference
