// A model program as the plant of a scenario (semantics 8, "Flown by a control program").
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/scenario.hpp"
#include "automata/step/marked_plant.hpp"
#include "runtime/executive/plant/plant_interface.hpp"
#include "runtime/executive/plant/sensor_script.hpp"
#include "runtime/executive/plant/simulated_model.hpp"

namespace rmpl::runtime {

/// One step a cycle. The start is drawn among those that have the real initial values of the scenario. A value that the
/// scenario forces is drawn: in the first step that ends at or after its time in which draws lead to it, and those
/// alone; together with others whose time has come, where that is possible. Sensors that the scenario dictates read
/// what it says. Same seed, same run.
class SimulatedSoftware final : public PlantInterface {
 public:
  /// Keeps references to all but the seed. Throws base::InputError where there is no such start.
  SimulatedSoftware(const automata::ModelProgram& program, const automata::MarkedPlant& plant,
                    const automata::Scenario& scenario, std::uint64_t seed);

  void issue(const automata::ControlAction& action, automata::Ticks now) override;
  /// Throws base::InputError where nothing can follow.
  const automata::Observation& sense(automata::Ticks now) override;
  void overhear(const automata::Modes& estimate, automata::Ticks now) override { script_.hear_estimate(estimate, now); }
  [[nodiscard]] const automata::Modes* truth() const override { return &truth_; }
  [[nodiscard]] const std::vector<Event>& happenings() const override { return happenings_; }
  [[nodiscard]] std::span<const Sample> samples() const override { return script_.samples(); }
  [[nodiscard]] const Monitors* monitors() const override { return script_.monitors(); }
  [[nodiscard]] bool more_to_come() const override { return !forced_.empty() || script_.pending(); }
  [[nodiscard]] bool waits_for_occasion() const override { return !forced_.empty() && forced_.front().at <= time_; }
  void finish(automata::Ticks now) const override;

 private:
  void step(automata::Ticks now);
  [[nodiscard]] automata::Assignment value_of(const automata::ForcedMode& forced) const;

  const automata::MarkedPlant& plant_;
  const automata::Scenario& scenario_;
  SimulatedModel model_;
  SensorScript script_;
  std::vector<automata::ForcedMode> forced_;  ///< that have not happened, by time
  automata::Ticks time_;                      ///< of the last step
  automata::Command command_;
  automata::Modes truth_;
  automata::Observation readings_;
  std::vector<Event> happenings_;
};

}  // namespace rmpl::runtime
