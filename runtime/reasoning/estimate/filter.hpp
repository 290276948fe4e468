// What keeps the belief of one group of components: the parts of an update (conditioning.hpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "base/function_ref.hpp"
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
  /// `adopt` or `stay`, one of which follows each step, with the readings that counted.
  virtual bool condition(const StepInput& input) = 0;
  /// After `condition` failed: works out the belief after the step given what is left of the observation, the rest
  /// being `set_aside`; wider as long as that goes on. False where nothing explains what is left. `doubtful`: what was
  /// not kept earlier might have explained the observation. May be called again, with less.
  virtual bool widen(const StepInput& rest, const automata::Observation& set_aside, bool doubtful) = 0;
  /// Takes what was worked out last as the belief; `consistent`: all readings counted.
  virtual void adopt(const StepInput& input, bool consistent) = 0;
  /// Keeps the belief, where no state follows; only time goes on.
  virtual void stay(const StepInput& input) = 0;
  /// Whether the last step changed nothing but the time, and the next one does the same where it is like it: as long,
  /// under the same action, with the same readings.
  [[nodiscard]] virtual bool steady() const = 0;
  /// In place of such a step.
  virtual void repeat(automata::Ticks now) = 0;
  /// Goes on from another belief, normalised, as of `now`; `missing` as in `Estimate::missing_total`.
  virtual void resume(Belief belief, double missing, automata::Ticks now) = 0;

  [[nodiscard]] virtual const Belief& belief() const = 0;
  /// Whether a test of modes holds for all that are tracked.
  [[nodiscard]] virtual bool all_modes(base::FunctionRef<bool(const automata::Modes&)> test) const = 0;
  /// The belief that the last step, which `adopt` or `stay` ended, started from.
  [[nodiscard]] virtual const Belief& before() const = 0;
  /// Of the last step; `consistent` tells of the initial belief alone.
  [[nodiscard]] virtual const Estimate& estimate() const = 0;
};

/// Makes filters of plants that are the same but for names. What rests on the plant alone they have in common, so that
/// they must not outlive it, and are asked one at a time.
class Filters {
 public:
  virtual ~Filters() = default;
  virtual std::unique_ptr<Filter> make() = 0;
};

/// Keep a reference to the step.
std::unique_ptr<Filters> exact_filters(automata::PlantStep& step, const EstimatorOptions& options);
std::unique_ptr<Filters> k_best_filters(automata::PlantStep& step, const EstimatorOptions& options);

}  // namespace rmpl::runtime
