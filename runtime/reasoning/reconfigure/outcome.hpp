// The word for what reconfiguration answered.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// `command`, `wait`, `no-plan`, `nothing-to-do`.
std::string_view name_of(Reconfiguration::Outcome outcome);

}  // namespace rmpl::runtime
