// What most likely happened over the last updates of a model program: the k most likely trajectories, revised as
// evidence comes. A trellis of each independent group of threads; the k best of all groups together are the best of the
// product.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "automata/dependencies/marking_groups.hpp"
#include "automata/step/marking_stages.hpp"
#include "automata/step/marking_step.hpp"
#include "runtime/reasoning/estimate/marking/marking_estimator.hpp"
#include "runtime/reasoning/estimate/marking/marking_filter.hpp"
#include "runtime/reasoning/estimate/reading.hpp"
#include "runtime/reasoning/estimate/window/trellis.hpp"

namespace rmpl::runtime {

/// Sets out from the beliefs of an estimator, as long as these explain what is read. Where one sets readings of a group
/// aside, and the histories of the window fewer, the beliefs of the updates in the window become what its histories
/// come to by then, and from there on the window keeps a belief of its own for the group: so that no window sets out
/// from what a reading has refuted.
class MarkingWindow {
 public:
  /// Over the last `options.window` updates, at least 1; `options.k` trajectories. Keeps a reference to the groups.
  MarkingWindow(const automata::MarkingGroups& groups, const MarkingOptions& options);

  /// Begins anew at time 0 with a belief, by group.
  void start(std::vector<GroupBelief> belief);
  /// One update further: what was told, by group, the belief that an estimator has come to, and how many readings that
  /// set aside.
  void update(std::vector<automata::Command> commands, std::vector<automata::Observation> observations,
              std::vector<GroupBelief> belief, const std::vector<std::size_t>& set_aside);
  /// The k most likely trajectories from the belief that many updates ago (or from time 0) until now, best first,
  /// normalised over all there are; ties to the smaller location numbers, the earliest marking first. Of readings that
  /// no trajectory explains a smallest set is set aside, and an update under which no step is possible leaves
  /// everything as it was. Throws TooManyStates.
  std::vector<MarkingTrajectory> trajectories();
  /// By update, oldest first: the readings that did not count when trajectories were told last.
  [[nodiscard]] std::vector<automata::Observation> set_aside() const;

 private:
  struct Told {
    std::vector<automata::Command> commands;
    std::vector<automata::Observation> observations;
  };
  /// What a group's trellis is made with.
  struct Part {
    explicit Part(const automata::ModelProgram& program) : step(program), stages(step) {}
    automata::MarkingStep step;
    automata::MarkingStages stages;
    Trellis trellis;
    std::vector<Counted> counted;                  ///< by update
    std::vector<std::vector<Trellis::Edge>> into;  ///< by place of the stages; empty between steps
    std::optional<MarkingFilter> own;              ///< none as long as the estimator's beliefs will do
  };

  void build(std::size_t group);
  void begin(std::size_t group);
  bool extend(std::size_t group, const automata::Command& command, const automata::Observation& readings);
  Counted count(std::size_t group, const Told& told);
  void set_right(std::size_t group, std::size_t set_aside, std::size_t set_aside_by_given, GroupBelief given);

  const automata::MarkingGroups& groups_;
  MarkingOptions options_;
  std::deque<Part> parts_;                     ///< by group; a part stays where it is
  std::deque<std::vector<GroupBelief>> from_;  ///< beliefs, oldest first: one more than `told_`
  std::deque<Told> told_;
};

}  // namespace rmpl::runtime
