// Why a run cannot go on: the constraints that contradict each other in what would follow.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::verifier {

/// Modes and constraints that contradict each other, none of which can be spared.
struct Conflict {
  std::vector<automata::Assignment> modes;         ///< in declaration order
  std::vector<automata::ComponentId> constrained;  ///< those whose mode's constraint takes part
  std::vector<std::size_t> interconnections;       ///< positions in the plant's
};

/// Of modes that are impossible. One solver, a question for each constraint.
Conflict conflict_of(const automata::Plant& plant, const automata::Modes& modes);

/// `one = a1 (file:line:column: one.at = one), two = a1 (…) and !(one.at = one & two.at = one)`; a place only where the
/// plant has it.
std::string to_text(const automata::Plant& plant, const Conflict& conflict, const automata::Modes& modes);

/// How a run is cut off.
struct Stop {
  bool still = false;                ///< time stands still; else nothing can follow
  std::optional<Conflict> conflict;  ///< of what a step would lead to; nothing where there is no step at all
  automata::Modes refused;           ///< that
};

/// `stuck: nothing can follow, as … contradict each other`, or that time stands still, and what to do about it.
std::string to_text(const automata::Plant& plant, const Stop& stop);

}  // namespace rmpl::verifier
