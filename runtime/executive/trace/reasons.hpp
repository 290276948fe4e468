// Why a cycle has its command, waits or is without a plan, as an object of a trace.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/plant.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// The key `reason` and its object, or nothing where there is nothing to do. `goal` is the cycle's.
void write_reason(JsonLine& line, Reconfiguration::Outcome outcome, const Reason& why,
                  const std::vector<automata::Assignment>& goal, const automata::Plant& plant);

}  // namespace rmpl::runtime
