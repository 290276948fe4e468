// What a reconfigurer answers with a planned step, and why (semantics 5, *Why*).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/goal.hpp"
#include "runtime/reasoning/reconfigure/planner.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// Puts answers in the terms of what was asked. Keeps a reference.
class Telling {
 public:
  explicit Telling(automata::PlantStep& step) : step_(step), idle_(idle_action(step.plant())) {}

  /// The step, taken for that purpose on a way to the target.
  Reconfiguration step(const automata::Modes& modes, const PlannedStep& step, const automata::Modes& target,
                       const Goal& goal, Reason::Purpose purpose);

  /// The first conjunct that is not entailed yet, of those that ask for modes of the component where there is one.
  std::optional<std::uint32_t> open_conjunct(const automata::Modes& modes, const Goal& goal,
                                             std::optional<automata::ComponentId> served);

 private:
  automata::PlantStep& step_;
  automata::ControlAction idle_;
};

}  // namespace rmpl::runtime
