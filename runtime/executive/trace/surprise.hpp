// The message of an update in which readings were set aside.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "automata/logic/variables.hpp"
#include "runtime/executive/trace/event.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

/// The event that names the readings; nothing where all counted. `variables` are the plant's.
std::optional<Event> surprise_of(const Estimate& estimate, const automata::Variables& variables);

}  // namespace rmpl::runtime
