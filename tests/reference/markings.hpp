// All markings that a program can come to while the plant does whatever its constraints allow, one after the other: the
// twin of compiler/lint/marking_search.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "automata/plant.hpp"
#include "automata/program.hpp"

namespace rmpl::reference {

struct MarkingsFound {
  std::set<automata::LocationId> marked;     ///< in some marking
  std::optional<std::size_t> contradiction;  ///< the first cycle, from 1, whose goals contradict each other
};

/// Per component, the modes that it may be in.
using ModesByComponent = std::vector<std::set<automata::ModeId>>;

/// The modes at the start; what transitions whose guards are satisfiable lead to from these in one step; and what they
/// lead to in any number of steps.
std::vector<ModesByComponent> modes_by_cycle(const automata::Plant& plant);

/// In each cycle modes and all attributes have any values that the plant permits, all of them known; a running clock
/// reads any of the readings, whole seconds and what stands for those between, that is not less than what it read
/// before; clocks that were started together read the same, and one that was started earlier reads more. Nothing where
/// there are more than `limit` different starts of cycles. `stages`: the modes of the first state, of the second and so
/// on, and of all from the last on; any modes where there are none.
std::optional<MarkingsFound> all_markings(const automata::Program& program, const automata::Plant& plant,
                                          const std::vector<automata::Ticks>& readings, std::size_t limit,
                                          const std::vector<ModesByComponent>& stages = {});

}  // namespace rmpl::reference
