// Mode estimation of model programs (semantics 8; ijcai01): beliefs over markings.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "automata/phca.hpp"
#include "automata/state.hpp"
#include "automata/step/marking_store.hpp"
#include "automata/step/program_rules.hpp"

namespace rmpl::runtime {

/// A marking, composites included, with its probability.
struct MarkingEntry {
  automata::Marking marking;
  double probability = 0;
  std::vector<automata::Assignment> values;  ///< what its store entails, by variable
};

/// Markings, composites included: where it set out from, and one an update.
struct MarkingTrajectory {
  double probability = 0;
  std::vector<automata::Marking> markings;
};

/// Most probable first; ties to the smaller location numbers.
using MarkingBelief = std::vector<MarkingEntry>;

/// How an update went.
struct MarkingEstimate {
  bool explained = true;  ///< false: some readings were set aside, or no step is possible
  bool possible = true;   ///< false: in some group no step is possible at all; its belief is the last one
  /// The readings that did not count, by variable: of each group a smallest set that nothing explains, as of
  /// `Estimate`.
  automata::Observation set_aside;
  bool cut = false;  ///< the limit of candidates ended the search early
  std::size_t checked = 0;
  /// k-best and beam: an upper bound of the probability that this update did not keep, as a share of the whole
  /// posterior that follows from the belief before.
  double missing_mass = 0;
  /// The same of all that the belief leaves out, in the posterior of the exact estimator (compare `Estimate`).
  double missing_total = 0;
};

struct MarkingOptions {
  enum class Kind {
    exact,   ///< the whole belief
    k_best,  ///< of each group of threads the k markings of greatest posterior
    beam     ///< the paper's: the k markings of greatest predicted probability among those that the readings allow
  };
  Kind kind = Kind::k_best;
  std::size_t k = 16;
  std::size_t listed = std::numeric_limits<std::size_t>::max();  ///< how many markings `belief` lists
  std::size_t candidates = 100'000;  ///< k-best and beam: how many a search of an update may check before it is cut
  std::size_t window = 0;            ///< exact and k-best: how many updates `history` goes back
  /// k-best and beam: ways out of one marking that are still summed; beyond, it searches. 0: 64 `k`, between
  /// 256 and 2^14.
  std::size_t most_summed = 0;
};

/// Starts at time 0 with the initial distribution.
class MarkingEstimator {
 public:
  virtual ~MarkingEstimator() = default;
  /// Conditions the initial belief on what is seen at time 0, in place of what an earlier call was told. Before the
  /// first update.
  virtual const MarkingEstimate& start(const automata::Observation& observation) = 0;
  /// The belief after a step under the command, and what is seen then. Throws TooManyStates, as the next does.
  virtual const MarkingEstimate& update(const automata::Command& command, const automata::Observation& observation) = 0;
  [[nodiscard]] virtual MarkingBelief belief() = 0;
  /// With `MarkingOptions::window`: the `k` most likely trajectories of that many updates, best first, normalised over
  /// all there are (marking_window.hpp). None without a window. Throws TooManyStates.
  [[nodiscard]] virtual std::vector<MarkingTrajectory> history() = 0;
  /// Of what `history` told last: by update, by place in a trajectory from 1 on, the readings that no trajectory
  /// explains, so that they do not count.
  [[nodiscard]] virtual std::vector<automata::Observation> set_aside_by_history() const = 0;
  /// Of the last update, or of the start: `possible` tells whether there is an initial marking at all.
  [[nodiscard]] virtual const MarkingEstimate& estimate() const = 0;
  /// How many independent groups there are.
  [[nodiscard]] virtual std::size_t groups() const = 0;
  /// How often the constraint stores were asked since the start, and how often that took a solver.
  [[nodiscard]] virtual std::size_t questions() = 0;
  [[nodiscard]] virtual std::size_t solver_calls() = 0;
};

/// Keeps a reference to the program.
std::unique_ptr<MarkingEstimator> make_marking_estimator(const automata::ModelProgram& program,
                                                         const MarkingOptions& options);

}  // namespace rmpl::runtime
