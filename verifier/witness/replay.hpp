// Replaying a run of a plant on the rules of semantics 3, apart from all that found it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/step/plain_step.hpp"
#include "verifier/property/commands.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// Under which rules a run is to be possible.
struct ReplayRules {
  std::optional<automata::Ticks> period;  ///< sampled time; none: dense
  Commands commands = Commands::one;      ///< of a plant alone
  unsigned faults = 0;
  std::vector<automata::Assignment> from = {};  ///< modes to start in, in place of the initial distribution
};

/// Why the run is not possible; nothing where it is. No search has a part in `rules`, which remember nothing.
///
/// Sampled: every period is possible by exact comparison of ticks, and has a positive probability. In a long wait only
/// those periods are looked at in which a clock is near a bound of its mode: between them nothing differs.
/// Dense: waits and steps by exact comparison of ticks.
std::optional<std::string> replay(automata::PlainStep& rules, const Witness& witness, const ReplayRules& replay_rules);

}  // namespace rmpl::verifier
