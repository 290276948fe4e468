// What missing plans and endless waits are due to, so that each cause is told once.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/program.hpp"
#include "automata/step/program_rules.hpp"
#include "runtime/reasoning/reconfigure/reason.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// What a missing plan or an endless wait is due to: the locations that ask or wait, and what bars the way.
struct Cause {
  std::vector<automata::LocationId> locations;
  std::string reason;
  auto operator<=>(const Cause&) const = default;
};

/// The goal without a plan, by the locations that ask for it, and why.
Cause no_plan_cause(const automata::Program& program, const automata::Marking& marking, const automata::Goals& goals,
                    const runtime::Reason& why, const std::string& reason);

/// The locations that wait.
Cause waiting_cause(const automata::Program& program, const automata::Marking& marking);

/// What the last cycle of a run is due to: its missing plans, or its wait.
std::vector<Cause> causes_of(const automata::Program& program, const Witness& witness, bool plans);

}  // namespace rmpl::verifier
