// What a plant can be in, be told and be seen as: modes, clocks, control actions, observations.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "automata/time/time.hpp"

namespace rmpl::automata {

/// A mode for each component, by `ComponentId`: the state s of thesis 6.1.3.
using Modes = std::vector<ModeId>;

/// The system state <s, t_init> of 6.2.2: modes, and for each component the time at which its clock started.
struct SystemState {
  Modes modes;
  std::vector<Ticks> clock_starts;
  auto operator<=>(const SystemState&) const = default;
};

/// A value for each control variable, by position in `Plant::controls`: the control action mu.
using ControlAction = std::vector<ValueId>;

/// Values of (some) observable variables, sorted by variable: the observation o.
using Observation = std::vector<Assignment>;

/// All controls at their idle values.
ControlAction idle_action(const Plant& plant);
/// Only the variables that are off their idle value, in declaration order.
std::vector<Assignment> commanded(const Plant& plant, const ControlAction& action);
/// All control variables with their values.
std::vector<Assignment> assignments_of(const Plant& plant, const ControlAction& action);
/// Mode variables with their values.
std::vector<Assignment> assignments_of(const Plant& plant, const Modes& modes);
/// The same, behind what `assignments` has.
void append_known(const Plant& plant, const Modes& modes, std::vector<Assignment>& assignments);
/// Idle, but for the given assignments. Throws base::InputError where one is no control variable.
ControlAction action_from(const Plant& plant, std::span<const Assignment> assignments);

struct ModesHash {
  std::size_t operator()(const Modes& modes) const noexcept;
};

}  // namespace rmpl::automata
