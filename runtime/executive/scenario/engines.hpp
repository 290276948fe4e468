// What an executive is put together from, by what a command line says of it and by the kind of plant.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "automata/logic/theory.hpp"
#include "automata/scenario.hpp"
#include "runtime/executive/plant/plant_interface.hpp"
#include "runtime/executive/scenario/run.hpp"

namespace rmpl::runtime {

/// Mode estimation as the executive uses it (the clock of a mode without a timed exit is forgotten), reconfiguration,
/// and what their plant looks like from outside.
class Engines {
 public:
  virtual ~Engines() = default;
  /// What a program is executed on: the plant, or the facade of a model program and its locations.
  [[nodiscard]] virtual const automata::Plant& model() const = 0;
  /// Of that model.
  [[nodiscard]] virtual automata::Theory& theory() = 0;
  [[nodiscard]] Estimator& estimator() { return *estimator_; }
  [[nodiscard]] Reconfigurer& reconfigurer() { return *reconfigurer_; }
  /// A plant that behaves as the model says, by chance, with what the scenario has in store.
  [[nodiscard]] virtual std::unique_ptr<PlantInterface> simulate(const automata::Scenario& scenario,
                                                                 std::uint64_t seed) = 0;

 protected:
  std::unique_ptr<Estimator> estimator_;
  std::unique_ptr<Reconfigurer> reconfigurer_;
};

/// Both keep a reference to what they are of. The second throws base::InputError where no start is consistent, or the
/// options ask for what model programs have not. `cycle`: of the executive.
std::unique_ptr<Engines> make_engines(const automata::Plant& plant, const ScenarioOptions& options,
                                      automata::Ticks cycle);
std::unique_ptr<Engines> make_engines(const automata::ModelProgram& program, const ScenarioOptions& options);

}  // namespace rmpl::runtime
