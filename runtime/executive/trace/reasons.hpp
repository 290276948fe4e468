// Why a cycle has its command, waits or is without a plan, as an object of a trace.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "automata/plant.hpp"
#include "automata/step/program_rules.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// The key `reason` and its object, or nothing where there is nothing to do. `goals` are the cycle's.
void write_reason(JsonLine& line, Reconfiguration::Outcome outcome, const Reason& why, const automata::Goals& goals,
                  const automata::Plant& plant);

/// The purpose and the obstacle of a name in such an object; `none` where it is no name of one.
Reason::Purpose purpose_named(std::string_view name);
Reason::Obstacle obstacle_named(std::string_view name);

}  // namespace rmpl::runtime
