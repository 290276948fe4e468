// Why there is no goal state, or no way to it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "automata/logic/ids.hpp"
#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/reason.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

struct Impasse {
  std::optional<automata::ComponentId> component;  ///< to blame, where there is one
  std::string reason;
  Reason why = {};  ///< obstacle, component, aim and step
};

/// *No plan*, and what the executive rests with.
Reconfiguration no_plan(automata::PlantStep& step, const automata::Modes& modes, Impasse impasse);

}  // namespace rmpl::runtime
