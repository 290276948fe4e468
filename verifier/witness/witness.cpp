// Witnesses: timed runs.
// SPDX-License-Identifier: MIT
#include "verifier/witness/witness.hpp"

#include "automata/fault_step.hpp"

namespace rmpl::verifier {

bool lacks_a_plan(const Cycle& cycle) {
  return cycle.outcome == runtime::Reconfiguration::Outcome::no_plan || !cycle.left_out.empty();
}

std::size_t faults_in(const automata::Plant& plant, const Witness& witness) {
  std::size_t faults = 0;
  for (std::size_t e = 1; e < witness.events.size(); ++e) {
    for (std::size_t c = 0; c < plant.components.size(); ++c) {
      const bool fault =
          automata::is_fault_step(plant.components[c], witness.events[e - 1].modes[c], witness.events[e].modes[c]);
      faults += fault ? 1 : 0;
    }
  }
  return faults;
}

}  // namespace rmpl::verifier
