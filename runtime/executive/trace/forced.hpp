// What a scenario forces, told from a fault.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/plant.hpp"
#include "runtime/executive/trace/cycle_record.hpp"

namespace rmpl::runtime {

/// Whether an event of the cycle is that a mode that is no fault was forced: a flag that is set, a switch that is
/// thrown. Never where the truth is not known.
bool is_forced_as_nominal(const Event& event, const CycleRecord& record, const automata::Plant& plant);

}  // namespace rmpl::runtime
