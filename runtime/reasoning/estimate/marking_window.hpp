// What most likely happened over the last updates of a model program: the k most likely trajectories, revised as
// evidence comes. A trellis of each independent group of threads; the k best of all groups together are the best of the
// product.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "automata/dependencies/marking_groups.hpp"
#include "automata/step/marking_step.hpp"
#include "runtime/reasoning/estimate/marking_estimator.hpp"
#include "runtime/reasoning/estimate/trellis.hpp"

namespace rmpl::runtime {

/// What a group's belief is, by primitive locations of the group.
using GroupBelief = std::vector<std::pair<automata::Marking, double>>;

class MarkingWindow {
 public:
  /// Over the last `updates`, at least 1; `k` trajectories. Keeps a reference to the groups.
  MarkingWindow(const automata::MarkingGroups& groups, std::size_t updates, std::size_t k);

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
  struct Told {
    std::vector<automata::Command> commands;
    std::vector<automata::Observation> observations;
  };
  enum class Reading { seen, unseen };

  void begin(std::size_t group);
  bool extend(std::size_t group, const Told& told, Reading reading);

  const automata::MarkingGroups& groups_;
  std::size_t updates_, k_;
  std::deque<automata::MarkingStep> steps_;    ///< by group
  std::vector<Trellis> trellis_;               ///< by group
  std::deque<std::vector<GroupBelief>> from_;  ///< beliefs, oldest first: one more than `told_`
  std::deque<Told> told_;
};

}  // namespace rmpl::runtime
