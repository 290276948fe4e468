// The leading system states over the extensions of all tracked ones: steps 4 to 6 of thesis Fig. 6-11.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/clock_collector.hpp"
#include "runtime/reasoning/estimate/clock_weights.hpp"
#include "runtime/reasoning/estimate/combination.hpp"
#include "runtime/reasoning/estimate/extensions.hpp"
#include "runtime/reasoning/estimate/filter.hpp"
#include "runtime/reasoning/estimate/joint_bound.hpp"

namespace rmpl::runtime {

/// One best-first queue over the extensions of several sources. Targets are mode combinations; without merging they are
/// states, and each source has one clock. What a target is worth is computed over all sources when its first trajectory
/// is found. A target that was not found yet has, in each source, no trajectory better than the best one left there:
/// the search ends when the sum of these bounds (without merging: the greatest of them), or what of it can be about one
/// target, is below the k-th best worth. Buffers are kept from run to run.
class TrajectorySearch {
 public:
  TrajectorySearch(const Clocks& clocks, const EstimatorOptions& options) : clocks_(clocks), options_(options) {}

  /// Finds the `k` best targets at `now`. A target of one of the `obligatory` sources, which are to be part of
  /// `sources` but for a smaller set of moves, is kept besides.
  /// A deadline that passes, as the limit of candidates, ends the search once there is a target at all.
  void run(std::span<const Source> sources, std::span<const Source> obligatory, automata::Ticks now, std::size_t k,
           const Deadline& deadline);

  /// Whether `run_again` may be asked for: the last run went to its end, in the order of priors and without obligatory
  /// sources, and did not grow out of what it needs.
  [[nodiscard]] bool repeatable(std::size_t k) const { return repeatable_ && k == k_; }
  /// The same as `run` from the sources of the last one, which may weigh something else now and step to a later time,
  /// after a time that is not 0; their extensions have not begun anew since. What was found stays, and is weighed anew;
  /// the search goes on from there where that is not enough. Costs a product for each known way from source to target.
  void run_again(std::span<const Source> sources, automata::Ticks now, const Deadline& deadline);

  /// Whether the last run was one of these, and what was found before was enough: it told nothing but how the known
  /// targets weigh, so that weights alone decide what another one gives.
  [[nodiscard]] bool only_weighed() const { return only_weighed_; }

  /// What was kept, in order, not normalised; the caller may take it away, and leave others for their memory.
  [[nodiscard]] Combinations& kept() { return kept_; }
  /// An upper bound of the worth of all consistent trajectories that are not in `kept`.
  [[nodiscard]] double lost() const { return lost_; }
  /// How many candidates were checked, and whether a limit was reached before the end.
  [[nodiscard]] std::size_t checked() const { return checked_; }
  [[nodiscard]] bool cut() const { return cut_; }

 private:
  /// A target state; `worth` is its posterior before normalisation.
  struct Target {
    automata::SystemState state;  ///< without merging with its clocks, else without
    double factor = 1;            ///< of the observation; 1 where it is not applied
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
  /// One way into a target, that is possible before the observation; `chance` is the product of the moves' priors, on
  /// average over the clocks of the source.
  struct Way {
    std::uint32_t target, source;
    double chance;
  };

  void line_up(std::span<const Source> sources);
  /// Whether bounds may take the observation factor into account once a search is long.
  [[nodiscard]] bool may_tighten() const { return options_.merge_trajectories && options_.observation_factor; }
  bool enough_found(std::span<const Source> sources);
  void tighten(std::span<const Source> sources);
  double unexplored(std::span<const Source> sources);
  void begin(std::size_t k, std::size_t sources);
  void take_up(std::span<const Source> sources, automata::Ticks now);
  void enumerate(std::span<const Source> sources, automata::Ticks now, const Deadline& deadline);
  std::pair<Target*, bool> reach(const Source& source, const Extension& extension, automata::Ticks now);
  void find_ways(Target& target, std::span<const Source> sources, automata::Ticks now);
  void weigh(Target& target, std::span<const Way> ways, std::span<const Source> sources) const;
  double chance(std::uint32_t number, const Source& source, const Target& target, automata::Ticks now);
  void tell(const Target& target, std::span<const Way> ways, std::span<const Source> sources, Combination& result);
  void add_clocks(const automata::Modes& modes, std::uint32_t number, const Source& source, double worth);
  void note(double worth);
  void keep(std::span<const Source> sources);
  void rebuild_index(std::size_t slots);

  const Clocks& clocks_;
  const EstimatorOptions& options_;
  std::vector<Target> targets_;  ///< the first `count_` are of this run; the rest is storage
  std::size_t count_ = 0;
  std::vector<Way> ways_;             ///< into the targets, those of one side by side, in order of source
  std::vector<std::uint32_t> index_;  ///< open addressing: position in `targets_` + 1, or 0; size a power of two
  std::vector<Front> fronts_;         ///< a heap
  std::vector<std::size_t> cursors_;  ///< per source, the next extension to look at
  /// Per source, the component that kept it from the last target that it does not lead to: most often, as for the one
  /// fault that sets it apart, the next target fails there as well.
  std::vector<std::size_t> barriers_;
  std::size_t k_ = 0;
  std::vector<double> best_;  ///< a heap: the k best worths, the least on top
  automata::Ticks now_;       ///< the time of the targets
  bool repeatable_ = false;
  bool only_weighed_ = false;
  bool looked_further_ = false;  ///< the last run looked at an extension, or for one
  std::size_t needed_ = 0;       ///< targets of the last run that began anew
  JointBound joint_;
  bool joint_known_ = false;   ///< `joint_` has looked at the sources as they are
  std::size_t next_look_ = 0;  ///< how many candidates are checked before it is asked again,
  std::size_t nodes_ = 0;      ///< and how long that may take then
  std::vector<double> left_;   ///< by source: what it has left
  double explored_ = 0;        ///< prior mass of all that was looked at
  double dropped_ = 0;         ///< worth of trajectories that lost to a better one into the same state
  double unexplored_ = 0;      ///< upper bound of the mass that was not looked at
  std::size_t checked_ = 0;
  bool cut_ = false;
  /// The last run was long, so that the next one takes the observation factor into account at once.
  bool long_ = false;
  bool tight_ = false;  ///< the sources were told to take the observation factor into account, or need not
  Combinations kept_;   ///< its memory serves the next run
  ClockWeights weights_;
  ClockCollector collected_;          ///< of the target that is being told,
  std::vector<std::size_t> telling_;  ///< and the components whose clocks matter there
  std::vector<std::pair<std::size_t, automata::Ticks>>
      entered_;  ///< components that a way moves, and their clock starts
  double lost_ = 0;
};

}  // namespace rmpl::runtime
