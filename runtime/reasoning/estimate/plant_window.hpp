// What most likely happened over the last updates of a plant: the k most likely trajectories of modes and clock starts,
// revised as evidence comes. A trellis of each independent group of components (compare marking_window.hpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

/// States: where it set out from, and one an update.
struct PlantTrajectory {
  double probability = 0;
  std::vector<automata::SystemState> states;
};

/// Keeps beliefs of its own, to set out from. Keeps a reference to the plant.
class PlantWindow {
 public:
  /// Over the last `updates`, at least 1; `options.k` trajectories, which set out from an exact belief, or from one of
  /// the `options.k` best states of each group.
  PlantWindow(const automata::Plant& plant, const EstimatorOptions& options, bool exact, std::size_t updates);
  ~PlantWindow();

  /// As of an `Estimator`. Throw TooManyStates.
  void start(const automata::Observation& observation);
  void update(const automata::ControlAction& action, const automata::Observation& observation, automata::Ticks now);
  /// The k most likely trajectories from the belief that many updates ago (or from time 0) until now, best first,
  /// normalised over all there are; ties in order of states, the earliest first. An update whose readings nothing
  /// explains counts without them. Throws TooManyStates.
  std::vector<PlantTrajectory> trajectories();

 private:
  class Part;
  struct Told;

  std::size_t updates_, k_, components_;
  std::unique_ptr<class Groups> groups_;  ///< none where the plant is one part
  std::vector<std::unique_ptr<Part>> parts_;
  std::deque<Told> told_;
  automata::Ticks last_;
};

}  // namespace rmpl::runtime
