// A plant that behaves as its model says, by chance (semantics 3; thesis 7.2.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/scenario.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/executive/plant/luck.hpp"
#include "runtime/executive/plant/plant_interface.hpp"
#include "runtime/executive/plant/sensor_script.hpp"
#include "runtime/executive/plant/sensors.hpp"

namespace rmpl::runtime {

/// Draws initial modes, transitions, faults and readings from the model: all components at once, and all again where
/// the store of the drawn state is inconsistent. Faults that the scenario forces happen in the first step that ends at
/// or after their time; those that are awaited in the first of these in which the model has them happen by chance, to
/// a component that is not there yet. So do those of software that the scenario forces. Sensors that the scenario
/// dictates read what it says. Same seed, same plant.
///
/// A plant that follows the luck of another one draws what that one drew, by step, component and sensor. Where the
/// store is inconsistent only those components draw again that have to do, by it, with one of those to blame.
class SimulatedPlant final : public PlantInterface {
 public:
  /// Keeps references to all. The step function may serve several flights. Throws base::InputError
  /// where no consistent initial state is found.
  SimulatedPlant(automata::PlantStep& step, const automata::Scenario& scenario, std::uint64_t seed,
                 std::vector<automata::ForcedMode> awaited = {}, LuckUse luck = {});

  void issue(const automata::ControlAction& action, automata::Ticks now) override;
  /// Throws base::InputError where no consistent next state is found: the model, or a forced mode, leads nowhere.
  const automata::Observation& sense(automata::Ticks now) override;
  void overhear(const automata::Modes& estimate, automata::Ticks now) override { script_.hear_estimate(estimate, now); }
  [[nodiscard]] const automata::Modes* truth() const override { return &state_.modes; }
  [[nodiscard]] const std::vector<Event>& happenings() const override { return happenings_; }
  [[nodiscard]] std::span<const Sample> samples() const override { return script_.samples(); }
  [[nodiscard]] const Monitors* monitors() const override { return script_.monitors(); }
  [[nodiscard]] bool more_to_come() const override {
    return !forced_.empty() || !awaited_.empty() || !owed_.empty() || script_.pending();
  }
  [[nodiscard]] bool waits_for_occasion() const override { return waits_for(time_); }
  void finish(automata::Ticks now) const override;

 private:
  void draw(const std::vector<std::vector<automata::Move>>& moves, automata::Ticks now);
  void draw_whole(const std::vector<std::vector<automata::Move>>& moves, automata::Ticks now);
  void draw_in_parts(const std::vector<std::vector<automata::Move>>& moves, automata::Ticks now);
  /// What is certain costs no number.
  automata::ModeId choose(const std::vector<automata::Move>& moves, std::size_t component);
  [[nodiscard]] bool faults_are_due(automata::Ticks now) const;
  [[nodiscard]] bool waits_for(automata::Ticks now) const;
  // Faults whose time has come take the place of what else the components could do: those that are awaited, those that
  // the scenario forces.
  void release(std::vector<std::vector<automata::Move>>& moves, automata::Ticks now);
  void force(std::vector<std::vector<automata::Move>>& moves, automata::Ticks now);
  void force(std::vector<automata::Move>& moves, const automata::ForcedMode& forced);
  /// Whether no outcome of these moves is possible; false where they are too many to look at.
  [[nodiscard]] bool is_stuck(const std::vector<std::vector<automata::Move>>& moves) const;
  /// After so many draws.
  [[noreturn]] void give_up(automata::Ticks now, int draws) const;

  const automata::Plant& plant_;
  automata::PlantStep& step_;
  LuckUse luck_;
  NumberSource numbers_;
  Sensors sensors_;
  SensorScript script_;
  std::vector<automata::ForcedMode> forced_;  ///< the next to happen stands last
  std::vector<automata::ForcedMode> awaited_;
  std::vector<automata::ForcedMode> owed_;  ///< the same of software in the scenario, which are to happen
  automata::SystemState state_;
  automata::Ticks time_;
  automata::ControlAction action_;
  automata::Modes drawn_;
  automata::Observation readings_;
  std::vector<Event> happenings_;
};

}  // namespace rmpl::runtime
