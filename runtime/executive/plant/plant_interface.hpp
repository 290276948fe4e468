// What a physical plant is to the executive: something that takes commands and gives observations (thesis 7.1.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "automata/state.hpp"
#include "runtime/executive/trace/event.hpp"
#include "runtime/telemetry/monitors.hpp"
#include "runtime/telemetry/sample.hpp"

namespace rmpl::runtime {

/// A plant, real or simulated. Calls come in the order of the cycle: `issue`, time passes, `sense`, `overhear`.
class PlantInterface {
 public:
  virtual ~PlantInterface() = default;
  /// Puts a command in force at `now`, until the next one.
  virtual void issue(const automata::ControlAction& action, automata::Ticks now) = 0;
  /// The readings at `now`, sorted by variable; a sensor that says nothing is absent. Lasts until the next call.
  virtual const automata::Observation& sense(automata::Ticks now) = 0;
  /// The executive's estimate at `now`: rule-based simulators eavesdrop on it (thesis 7.2.1).
  virtual void overhear(const automata::Modes& estimate, automata::Ticks now) = 0;
  /// The real modes as of the last `sense`, where somebody knows them; else null.
  [[nodiscard]] virtual const automata::Modes* truth() const = 0;
  /// What happened to the plant in the last `sense` that the executive is not told, for the trace.
  [[nodiscard]] virtual const std::vector<Event>& happenings() const = 0;
  /// The samples of channels that came with the last `sense`, in order of time; empty where there are no channels.
  [[nodiscard]] virtual std::span<const Sample> samples() const { return {}; }
  /// What makes readings of them; null where there are no channels.
  [[nodiscard]] virtual const Monitors* monitors() const { return nullptr; }
  /// Whether something that was scripted still lies ahead.
  [[nodiscard]] virtual bool more_to_come() const = 0;
  /// Whether something whose time has come waits for an occasion.
  [[nodiscard]] virtual bool waits_for_occasion() const { return false; }
  /// The run is over, at `now`. Throws base::InputError where what was scripted until then never had an occasion.
  virtual void finish(automata::Ticks /*now*/) const {}
};

}  // namespace rmpl::runtime
