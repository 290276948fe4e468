// What keeps the belief of one group of components: the two halves of an update, so that several groups can agree on
// it.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

/// Until when a search may go on; nothing sets no limit.
using Deadline = std::optional<std::chrono::steady_clock::time_point>;

/// What a step is about: the control action in force since the last one, and what is seen at its end.
struct StepInput {
  const automata::ControlAction& action;
  const automata::Observation& observation;
  automata::Ticks now;
  Deadline deadline;
};

/// The belief of a plant, or of a part that is independent of the rest. Starts at time 0 as `Estimator` does.
class Filter {
 public:
  virtual ~Filter() = default;
  /// The belief at time 0, given what is seen there; false, and the belief without it, where nothing explains that.
  /// Before the first step; `estimate().consistent` tells whether there is an initial state at all.
  virtual bool start(const automata::Observation& observation) = 0;
  /// Works out the belief after a step; false where nothing explains the observation. The belief stays as it was until
  /// `adopt` or `stay`, one of which follows each step, with the same input.
  virtual bool condition(const StepInput& input) = 0;
  /// After `condition`: works out the last belief carried forward without the observation, wider where `condition`
  /// failed; false where no state is possible at all. `doubtful`: what was not kept earlier, here or in another group,
  /// might have explained the observation.
  virtual bool predict(const StepInput& input, bool doubtful) = 0;
  /// Takes what was worked out last as the belief.
  virtual void adopt(const StepInput& input, bool consistent) = 0;
  /// Keeps the belief; only time goes on.
  virtual void stay(const StepInput& input) = 0;
  /// Goes on from another belief, normalised, as of `now`; `missing` as in `Estimate::missing_total`.
  virtual void resume(Belief belief, double missing, automata::Ticks now) = 0;

  [[nodiscard]] virtual const Belief& belief() const = 0;
  /// The belief that the last step, which `adopt` or `stay` ended, started from.
  [[nodiscard]] virtual const Belief& before() const = 0;
  /// Of the last step; `consistent` tells of the initial belief alone.
  [[nodiscard]] virtual const Estimate& estimate() const = 0;
};

std::unique_ptr<Filter> make_exact_filter(automata::PlantStep& step, const EstimatorOptions& options);
std::unique_ptr<Filter> make_k_best_filter(automata::PlantStep& step, const EstimatorOptions& options);

}  // namespace rmpl::runtime
