// What k-best knows of a plant, whatever it believes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/clock_merging.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/openings.hpp"
#include "runtime/reasoning/estimate/possible_share.hpp"

namespace rmpl::runtime {

/// Worked out once for all filters of plants that are the same but for names. These are asked one at a time.
struct KBestModel {
  /// Up to so many extensions, components in a conflict are predicted exactly, and shares of what is possible summed.
  static constexpr std::size_t exact_limit = 4096;

  /// Keeps a reference to the step.
  KBestModel(automata::PlantStep& of, const EstimatorOptions& how)
      : step(of),
        options(how),
        clocks(of.plant(), how.live_clocks_only),
        has_restarts(automata::has_restarts(of.plant())),
        possible(of, exact_limit),
        merging(of.plant(), clocks, possible.excluding()) {
    if (how.observation_factor && how.merge_trajectories) openings.emplace(of.plant());
  }
  KBestModel(const KBestModel&) = delete;  // members refer to each other
  KBestModel& operator=(const KBestModel&) = delete;

  automata::PlantStep& step;
  const EstimatorOptions options;
  const Clocks clocks;
  const bool has_restarts;
  PossibleShare possible;
  const ClockMerging merging;
  std::optional<Openings> openings;  ///< where bounds take the observation factor into account
};

}  // namespace rmpl::runtime
