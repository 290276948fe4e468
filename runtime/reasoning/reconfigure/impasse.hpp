// Why there is no goal state, or no way to it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "automata/logic/ids.hpp"
#include "runtime/reasoning/reconfigure/reason.hpp"

namespace rmpl::runtime {

struct Impasse {
  std::optional<automata::ComponentId> component;  ///< to blame, where there is one
  std::string reason;
  Reason why = {};                                             ///< obstacle, component, aim and step
  std::optional<automata::ComponentId> serves = std::nullopt;  ///< the one on whose way it lies, where that is known
};

}  // namespace rmpl::runtime
