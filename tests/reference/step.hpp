// One step of a plant with its probabilities, word by word from semantics 3: the twin of automata/step/plant_step.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "tests/reference/models.hpp"

namespace rmpl::reference {

/// 1 - G(t) of a timed transition: the density, truncated to [lower, upper], integrated from t on.
double survival(const automata::Timing& timing, automata::Ticks t);

/// The step function. Keeps a reference to the plant.
class Step {
 public:
  explicit Step(const automata::Plant& plant) : plant_(plant), models_(plant) {}

  [[nodiscard]] const automata::Plant& plant() const { return plant_; }
  [[nodiscard]] const Models& models() const { return models_; }

  [[nodiscard]] bool possible(const automata::Modes& modes) const;

  /// Whether the store of the modes, with the control action, implies the guard of a transition.
  [[nodiscard]] bool enabled(const automata::Transition& transition, const automata::Modes& modes,
                             const automata::ControlAction& action) const;

  /// Per mode of the component, the probability of being in it after the step that ends at `now`.
  [[nodiscard]] std::vector<double> distribution(std::size_t component, const automata::SystemState& state,
                                                 const automata::ControlAction& action, automata::Ticks before,
                                                 automata::Ticks now) const;

  /// P_O of Fig. 6-10, with the correction of semantics 4: 0 where the observations are jointly inconsistent.
  [[nodiscard]] double observation_factor(const automata::Modes& modes, const automata::Observation& observation) const;
  [[nodiscard]] bool explains(const automata::Modes& modes, const automata::Observation& observation) const;

  /// Whether a restart starts the clock of a component anew.
  [[nodiscard]] bool restarts(std::size_t component, const automata::Modes& modes,
                              const automata::ControlAction& action) const;
  /// The state after `next` was entered at `now`: a clock starts anew when its mode changes, or by a restart.
  [[nodiscard]] automata::SystemState advance(const automata::SystemState& state, const automata::ControlAction& action,
                                              const automata::Modes& next, automata::Ticks now) const;

 private:
  const automata::Plant& plant_;
  Models models_;
};

}  // namespace rmpl::reference
