// Diagnoses of one snapshot by looking at every assignment of modes: the twin of runtime/diagnose.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::reference {

struct Diagnosis {
  std::vector<std::pair<automata::ComponentId, automata::ModeId>> faults;  ///< in order of component
  double probability = 0;  ///< the prior: a component began in the fault, or began in none and entered it
};

/// Every set of faults that, with some nominal mode for each other component, is consistent with the observations;
/// most probable first, those of probability 0 too.
std::vector<Diagnosis> diagnoses(const automata::Plant& plant, const automata::Observation& observation);

}  // namespace rmpl::reference
