// Where a run may start.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/step/plant_step.hpp"

namespace rmpl::verifier {

/// Why a run may not start in these modes, `from` standing in place of the initial distribution of the components that
/// it names; nothing where it may.
std::optional<std::string> wrong_start(automata::PlantStep& step, const automata::Modes& modes,
                                       const std::vector<automata::Assignment>& from);

}  // namespace rmpl::verifier
