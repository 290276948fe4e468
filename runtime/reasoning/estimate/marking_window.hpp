// What most likely happened over the last updates: the k most likely trajectories, revised as evidence comes.
//
// A trellis of each independent group of threads: forward, the probability of the best way to each marking (Viterbi;
// Forney 1973); backward, the k best sequences in order, by that as the exact remainder (Nilsson & Goldberger 2001, in
// the form of Soong & Huang). The k best of all groups together are then the best of the product.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "automata/step/marking_step.hpp"
#include "runtime/reasoning/estimate/marking_estimator.hpp"
#include "runtime/reasoning/estimate/marking_groups.hpp"

namespace rmpl::runtime {

/// What a group's belief is, by primitive locations of the group.
using GroupBelief = std::vector<std::pair<automata::Marking, double>>;

class MarkingWindow {
 public:
  /// Over the last `updates`, at least 1; `k` trajectories. Keeps a reference to the groups.
  MarkingWindow(const MarkingGroups& groups, std::size_t updates, std::size_t k);

  /// Begins anew at time 0 with a belief, by group.
  void start(std::vector<GroupBelief> belief);
  /// One update further: what was told, by group, and the belief that an estimator has come to.
  void update(std::vector<automata::Command> commands, std::vector<automata::Observation> observations,
              std::vector<GroupBelief> belief);
  /// The k most likely trajectories from the belief that many updates ago (or from time 0) until now, best first,
  /// normalised over all there are; ties to the smaller location numbers, the earliest marking first. An update whose
  /// readings nothing explains counts without them, and one under which no step is possible leaves everything as it
  /// was. Throws TooManyStates.
  std::vector<MarkingTrajectory> trajectories();

 private:
  using Number = automata::MarkingStep::Number;
  struct Edge {
    std::uint32_t from;  ///< place in the layer before
    double probability;  ///< with the observation factor
  };
  /// The markings at one time.
  struct Layer {
    std::vector<Number> markings;
    std::vector<std::vector<Edge>> into;
    std::vector<double> sum;   ///< of all ways there, normalised
    std::vector<double> best;  ///< of the best way there, in the same unit
  };
  using Trellis = std::vector<Layer>;
  struct Told {
    std::vector<automata::Command> commands;
    std::vector<automata::Observation> observations;
  };
  enum class Reading { seen, unseen };
  struct Path {
    double probability;
    std::vector<Number> markings;
  };

  Layer first(std::size_t group);
  bool extend(std::size_t group, const Told& told, Reading reading, Layer& next);
  void stand(std::size_t group, Layer& next);
  std::vector<Path> paths(std::size_t group);

  const MarkingGroups& groups_;
  std::size_t updates_, k_;
  std::deque<automata::MarkingStep> steps_;    ///< by group
  std::vector<Trellis> trellis_;               ///< by group
  std::deque<std::vector<GroupBelief>> from_;  ///< beliefs, oldest first: one more than `told_`
  std::deque<Told> told_;
};

}  // namespace rmpl::runtime
