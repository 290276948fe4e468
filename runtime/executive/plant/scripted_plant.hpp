// A plant that follows the rules alone: no model behind it, sensors say what the scenario dictates (thesis 7.2.1).
// SPDX-License-Identifier: MIT
#pragma once

#include "runtime/executive/plant/plant_interface.hpp"
#include "runtime/executive/plant/sensor_script.hpp"

namespace rmpl::runtime {

/// Observations come from overrides and rules; a sensor that none speaks of is silent. There is no truth.
class ScriptedPlant final : public PlantInterface {
 public:
  ScriptedPlant(const automata::Plant& plant, const automata::Scenario& scenario) : script_(plant, scenario) {}

  void issue(const automata::ControlAction& action, automata::Ticks now) override { script_.hear_command(action, now); }
  const automata::Observation& sense(automata::Ticks now) override {
    readings_.clear();
    script_.apply(readings_, now);
    happenings_.clear();
    script_.add_remarks(happenings_);
    return readings_;
  }
  void overhear(const automata::Modes& estimate, automata::Ticks now) override { script_.hear_estimate(estimate, now); }
  [[nodiscard]] const automata::Modes* truth() const override { return nullptr; }
  [[nodiscard]] const std::vector<Event>& happenings() const override { return happenings_; }
  [[nodiscard]] std::span<const Sample> samples() const override { return script_.samples(); }
  [[nodiscard]] const Monitors* monitors() const override { return script_.monitors(); }
  [[nodiscard]] bool more_to_come() const override { return script_.pending(); }

 private:
  SensorScript script_;
  automata::Observation readings_;
  std::vector<Event> happenings_;
};

}  // namespace rmpl::runtime
