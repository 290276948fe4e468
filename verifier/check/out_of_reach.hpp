// What no run can come to, as a look at each component by itself and one question to the solver tell.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/step/plant_step.hpp"

namespace rmpl::verifier {

/// Whether the store allows the formula in no modes that the components can come to with so many faults each, were
/// every guard implied at some time. `from` as in CheckOptions. Sufficient: false where that is not seen.
bool out_of_reach(automata::PlantStep& step, const automata::Formula& formula,
                  const std::vector<automata::Assignment>& from, unsigned faults);

}  // namespace rmpl::verifier
