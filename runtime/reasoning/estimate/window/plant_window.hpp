// What most likely happened over the last updates of a plant: the k most likely trajectories of modes and clock starts,
// revised as evidence comes. A trellis of each independent group of components (compare marking_window.hpp); a group
// with too many states for that is searched, best first (window_search.hpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/reading.hpp"

namespace rmpl::runtime {

/// States: where it set out from, and one an update.
struct PlantTrajectory {
  double probability = 0;
  std::vector<automata::SystemState> states;
};

/// Keeps beliefs of its own, to set out from. Where these set readings of a group aside, and the histories of the
/// window fewer, the beliefs of the updates in the window become what its histories come to by then, and are kept from
/// there on: so that no window sets out from what a reading has refuted. Keeps a reference to the plant.
class PlantWindow {
 public:
  /// More ways to go on in one update than this are searched.
  static constexpr std::size_t most_ways = std::size_t{1} << 16;

  /// Over the last `updates`, at least 1; `options.k` trajectories, which set out from an exact belief, or from one of
  /// the `options.k` best states of each group. A group with more than `ways` in one update is searched from then on.
  PlantWindow(const automata::Plant& plant, const EstimatorOptions& options, bool exact, std::size_t updates,
              std::size_t ways = most_ways);
  ~PlantWindow();

  /// As of an `Estimator`. Throw TooManyStates.
  void start(const automata::Observation& observation);
  void update(const automata::ControlAction& action, const automata::Observation& observation, automata::Ticks now);
  /// The k most likely trajectories from the belief that many updates ago (or from time 0) until now, best first,
  /// normalised over all there are, where a group is searched over the k best of it; ties in order of states, the
  /// earliest first. Of readings that no history explains a smallest set of each group is set aside. Throws
  /// TooManyStates.
  std::vector<PlantTrajectory> trajectories();
  /// By update, oldest first: the readings that did not count when trajectories were told last.
  [[nodiscard]] std::vector<automata::Observation> set_aside() const;
  /// Whether a search ended early, so that the trajectories told last are the best, but fewer than k.
  [[nodiscard]] bool cut() const;
  /// Whether a group is searched.
  [[nodiscard]] bool searched() const;

 private:
  class Part;
  struct Told;

  void set_right(std::size_t part);

  std::size_t updates_, k_;
  std::size_t components_;
  std::unique_ptr<class Groups> groups_;  ///< none where the plant is one part
  std::vector<std::unique_ptr<Part>> parts_;
  std::deque<Told> told_;
  automata::Ticks last_;
};

}  // namespace rmpl::runtime
