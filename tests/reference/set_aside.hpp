// Readings that nothing explains, by trying every subset: fewest first, then in order.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "automata/state.hpp"

namespace rmpl::reference {

/// What is set aside and what remains; nothing where `explained` refuses even no readings.
struct SetAside {
  automata::Observation aside, rest;
};
std::optional<SetAside> set_aside(const automata::Observation& seen,
                                  const std::function<bool(const automata::Observation&)>& explained);

}  // namespace rmpl::reference
