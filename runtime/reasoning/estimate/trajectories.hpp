// The leading system states over the extensions of all tracked ones: steps 4 to 6 of thesis Fig. 6-11.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/extensions.hpp"
#include "runtime/reasoning/estimate/filter.hpp"
#include "runtime/reasoning/estimate/joint_bound.hpp"

namespace rmpl::runtime {

/// One best-first queue over the extensions of several sources. What a target state is worth is computed over all
/// sources when its first trajectory is found. A state that was not found yet has, in each source, no trajectory better
/// than the best one left there: the search ends when the sum of these bounds (without merging: the greatest of them),
/// or what of it can be about one state, is below the k-th best worth. Buffers are kept from run to run.
class TrajectorySearch {
 public:
  TrajectorySearch(const Clocks& clocks, const EstimatorOptions& options) : clocks_(clocks), options_(options) {}

  /// Finds the `k` best targets at `now`. A target of one of the `obligatory` sources, which are to be part of
  /// `sources` but for a smaller set of moves, is kept besides.
  /// A deadline that passes, as the limit of candidates, ends the search once there is a target at all.
  void run(std::span<const Source> sources, std::span<const Source> obligatory, automata::Ticks now, std::size_t k,
           const Deadline& deadline);

  /// What was kept, in order, not normalised; the caller may take it away.
  [[nodiscard]] Belief& kept() { return kept_; }
  /// An upper bound of the worth of all consistent trajectories that are not in `kept`.
  [[nodiscard]] double lost() const { return lost_; }
  /// How many candidates were checked, and whether a limit was reached before the end.
  [[nodiscard]] std::size_t checked() const { return checked_; }
  [[nodiscard]] bool cut() const { return cut_; }

 private:
  /// A target state; `worth` is its posterior before normalisation.
  struct Target {
    automata::SystemState state;
    double prior = 0;
    double worth = 0;
    std::uint32_t leading = 0;  ///< the source of its best trajectory
    bool obligatory = false;
  };
  /// The best that a source has left.
  struct Front {
    double bound;
    std::uint32_t source;
    /// A type, not a function: heaps of them are inner loops.
    struct ByBound {
      bool operator()(const Front& a, const Front& b) const {
        return a.bound != b.bound ? a.bound < b.bound : a.source > b.source;
      }
    };
  };
  /// One way into a target, that is possible before the observation.
  struct Way {
    std::uint32_t target, source;
    double probability;
  };

  void line_up(std::span<const Source> sources);
  bool enough_found(std::span<const Source> sources);
  void tighten(std::span<const Source> sources);
  double unexplored(std::span<const Source> sources);
  void enumerate(std::span<const Source> sources, automata::Ticks now, std::size_t k, const Deadline& deadline);
  std::pair<Target*, bool> reach(const Source& source, const Extension& extension, automata::Ticks now);
  void weigh(Target& target, double factor, std::span<const Source> sources, automata::Ticks now);
  double trajectory(std::uint32_t number, const Source& source, const Target& target, automata::Ticks now);
  void note(double worth, std::size_t k);
  void keep(std::size_t k);
  void grow_index();

  const Clocks& clocks_;
  const EstimatorOptions& options_;
  std::vector<Target> targets_;  ///< the first `count_` are of this run; the rest is storage
  std::size_t count_ = 0;
  std::vector<Way> ways_;             ///< into the targets
  std::vector<std::uint32_t> index_;  ///< open addressing: position in `targets_` + 1, or 0; size a power of two
  std::vector<Front> fronts_;         ///< a heap
  std::vector<std::size_t> cursors_;  ///< per source, the next extension to look at
  /// Per source, the component that kept it from the last target that it does not lead to: most often, as for the one
  /// fault that sets it apart, the next target fails there as well.
  std::vector<std::size_t> barriers_;
  std::vector<double> best_;  ///< a heap: the k best worths, the least on top
  JointBound joint_;
  bool joint_known_ = false;   ///< `joint_` has looked at the sources as they are
  std::size_t next_look_ = 0;  ///< how many candidates are checked before it is asked again
  std::vector<double> left_;   ///< by source: what it has left
  double explored_ = 0;        ///< prior mass of all that was looked at
  double dropped_ = 0;         ///< worth of trajectories that lost to a better one into the same state
  double unexplored_ = 0;      ///< upper bound of the mass that was not looked at
  std::size_t checked_ = 0;
  bool cut_ = false;
  bool long_ =
      false;  ///< the last run was long, so that the next one takes the observation factor into account at once
  bool tight_ = false;  ///< the sources were told to take the observation factor into account, or need not
  Belief kept_;
  double lost_ = 0;
};

}  // namespace rmpl::runtime
