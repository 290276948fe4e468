// Mode estimation: the interface behind which exact and k-best estimators stand (semantics 4; thesis 6.2).
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "base/peak_memory.hpp"

namespace rmpl::runtime {

/// One system state with its probability.
struct BeliefEntry {
  automata::SystemState state;
  double probability = 0;
};

/// More states would have to be listed, or kept in one belief, than there is room for.
class TooManyStates : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A calculation was ended from outside. What was to be worked out is lost, and the estimator with it.
class Interrupted : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }
};

/// A calculation would take more memory than it may. What was to be worked out is lost, and the estimator with it.
class MemorySpent : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "the limit of memory (--max-memory) was reached"; }
};

/// Most probable first; ties in order of modes (components, then modes, in declaration order), then of clock starts.
using Belief = std::vector<BeliefEntry>;

/// What one update gives.
struct Estimate {
  automata::Modes modes;   ///< the most likely plant state: summed over clocks; ties to the first in declaration order
  double probability = 0;  ///< its share of the belief
  /// False: no state that is tracked explains all readings, or none follows at all; of the start: none is possible.
  bool consistent = true;
  bool follows = true;  ///< false: in some group no state follows
  /// The readings that did not count, by variable: of each group a smallest set without which a state that is tracked
  /// explains the rest, of several the first in order of variable. All of a group in which no state follows: there the
  /// belief stays as it was.
  automata::Observation set_aside;
  /// By component: whether a reading of its group was set aside. Empty where none was.
  std::vector<bool> surprised;
  bool cut = false;         ///< the limit of candidates or the deadline ended the search early
  std::size_t checked = 0;  ///< candidates checked in this update
  /// k-best: an upper bound of the probability that this update did not keep, as a share of the whole posterior that
  /// follows from the belief before.
  double missing_mass = 0;
  /// k-best: an upper bound of the probability, in the posterior that the exact estimator has, of all that the belief
  /// leaves out: what was not kept in any update since the start may all have come to where it explains everything.
  double missing_total = 0;
  std::uint64_t rank = 0;  ///< with `EstimatorOptions::ranks`: of the best state
};

struct EstimatorOptions {
  std::size_t k = 16;                ///< mode combinations kept by k-best (of `--thesis`: states); at least 1
  std::size_t clocks = 64;           ///< k-best: values of the clock of a component in each of k combinations
  std::size_t candidates = 100'000;  ///< k-best: how many candidates an update may check before it is cut
  /// k-best: a search that has checked so many candidates takes the observation factor into its bounds; most end
  /// before. The one after it does so at once, until half as many are enough.
  std::size_t patience = 32;
  /// k-best: how long an update may search; the best states found until then are kept, at least one.
  std::optional<std::chrono::nanoseconds> deadline = std::nullopt;
  /// Keep the belief as a product over independent groups of components: exact, and exponential in the largest group
  /// only. `belief()` multiplies out the best of the product: the k best mode combinations with k-best, which then need
  /// not add up to 1, the `listed` best states with exact.
  bool factored = true;
  std::size_t listed = std::numeric_limits<std::size_t>::max();
  /// Add up trajectories that meet; and drop what cannot happen next from the outcomes of each state, the rest being
  /// scaled to 1, state by state (semantics 3). Off in `--thesis`.
  bool merge_trajectories = true;
  bool observation_factor = true;  ///< apply the 1/m of semantics 4; off in `--thesis`
  bool normalise = true;           ///< off in `--thesis`: Fig. 6-11 returns f(tau) as it is
  /// Count instead of weigh, as Livingstone2 does: a probability is a power of ten, the nearest one, whose exponent is
  /// its rank; ranks of a trajectory add up; of trajectories that meet the best counts, and all states that are as good
  /// as the k-th are kept. With the three above off. A probability of the belief is then 10 to the minus of the
  /// difference of its rank to the best, which `Estimate::rank` tells.
  bool ranks = false;
  /// Forget the clock of a component while its mode needs none (automata/clock_use.hpp): exact on modes, and states
  /// that differ only in such clocks become one. Fig. 6-10 keeps all clocks.
  bool live_clocks_only = false;
  /// k-best: the bound of what is missing takes into account which readings no modes imply; finding out may cost more
  /// than the estimate.
  bool account = false;
  /// Set from outside, it ends an update that goes on: throws Interrupted. Nothing does where there is none.
  const std::atomic<bool>* interruption = nullptr;
  /// exact: resident memory of the process, at its peak, at which an update ends: throws MemorySpent.
  std::optional<std::size_t> bytes = std::nullopt;

  /// To be called often.
  void go_on() const {
    if (interruption != nullptr && interruption->load(std::memory_order_relaxed)) throw Interrupted();
  }
  /// To be called now and then.
  void keep_within_memory() const {
    if (bytes && base::peak_memory() >= *bytes) throw MemorySpent();
  }
};

/// Modes of some components that what is seen does not allow together.
using RefutedModes = std::vector<std::pair<automata::ComponentId, automata::ModeId>>;

/// An estimator starts at time 0 with all clocks 0 and the initial distribution.
class Estimator {
 public:
  virtual ~Estimator() = default;
  /// Conditions the initial belief on what is seen at time 0, before any step; in place of what an earlier call was
  /// told. Before the first update. Readings that nothing explains are set aside.
  virtual const Estimate& start(const automata::Observation& observation) = 0;
  /// The belief after the control action that was in force since the last update and the observations at `now`, which
  /// is not before the last update.
  /// Throws TooManyStates where groups have to be taken together and that is too much.
  virtual const Estimate& update(const automata::ControlAction& action, const automata::Observation& observation,
                                 automata::Ticks now) = 0;
  /// Throws TooManyStates where more than a million states of a product are to be listed.
  [[nodiscard]] virtual const Belief& belief() const = 0;
  /// The belief about some components, each state with its share: of the groups that these belong to, multiplied out
  /// to the best few thousand states. The modes of all others are those of the estimate. Clocks are not told.
  [[nodiscard]] virtual Belief belief_about(std::span<const automata::ComponentId>) const { return belief(); }
  [[nodiscard]] virtual const Estimate& estimate() const = 0;  ///< of the last update, or of the initial belief
  /// Whether the last update is known to have left belief and estimate as they were, all but the time.
  [[nodiscard]] virtual bool stayed() const { return false; }
  /// What was most likely at the last update, before its observation was looked at, without one mode of one component
  /// and without what is `refuted`: where the likeliest step leads that some state of the belief before can take.
  /// Nothing where no step avoids all that, or before the first update. A search; for explanations
  /// (explain/explainer.hpp), not for every cycle. Of `refuted`, components of different groups are not looked at.
  [[nodiscard]] virtual std::optional<automata::Modes> likeliest_without(
      automata::ComponentId /*component*/, automata::ModeId /*mode*/,
      const std::vector<RefutedModes>& /*refuted*/) const {
    return std::nullopt;
  }
  /// Whether `likeliest_without` ever tells anything; where it does not, no diagnosis is explained.
  [[nodiscard]] virtual bool tells_rivals() const { return false; }
  /// The share of the belief that is in these modes, summed over clocks.
  [[nodiscard]] virtual double probability_of(const automata::Modes& modes) const = 0;
  /// How many independent groups the belief is kept as.
  [[nodiscard]] virtual std::size_t groups() const = 0;
  /// How often the constraint stores were asked since the start, and how often that took a solver.
  [[nodiscard]] virtual std::size_t questions() const = 0;
  [[nodiscard]] virtual std::size_t solver_calls() const = 0;
};

/// BeliefUpdate of Fig. 6-10, with normalisation: the whole belief. The reference; exponential in the components.
/// Keeps a reference to the plant, and where there is one to its step function: without one, the estimator makes one of
/// the whole plant when it keeps that as one group, and else of each shape of group alone.
std::unique_ptr<Estimator> make_exact_estimator(automata::PlantStep& step, const EstimatorOptions& options);
std::unique_ptr<Estimator> make_exact_estimator(const automata::Plant& plant, const EstimatorOptions& options);
/// TimedME of Fig. 6-11 by conflict-directed A*, with the corrections of semantics 4 as `options` say.
std::unique_ptr<Estimator> make_k_best_estimator(automata::PlantStep& step, const EstimatorOptions& options);
std::unique_ptr<Estimator> make_k_best_estimator(const automata::Plant& plant, const EstimatorOptions& options);

}  // namespace rmpl::runtime
