// The diagnoses that an update brings, each with its evidence.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/explain/evidence.hpp"

namespace rmpl::runtime {

/// Explains the diagnoses of one run. As long as there is none it costs a look at each component.
class Explainer {
 public:
  /// Keeps a reference to the plant.
  explicit Explainer(const automata::Plant& plant) : plant_(plant) {}

  /// For each component that the last update of `estimator`, by `observation`, newly puts into a fault mode: not the
  /// one that it had in `before`, the estimate until then, which may be empty. In order of components; nothing where no
  /// state follows. `observation`: without what was set aside.
  std::vector<Evidence> evidence_of_new(const automata::Modes& before, const Estimator& estimator,
                                        const automata::Observation& observation);

 private:
  Evidence evidence_of(automata::ComponentId component, const Estimator& estimator,
                       const automata::Observation& observation);

  const automata::Plant& plant_;
  std::optional<Evidences> evidences_;  ///< once there was a diagnosis
};

}  // namespace rmpl::runtime
