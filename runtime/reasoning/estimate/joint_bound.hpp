// What several sources together can still give to one target that was not found yet.
//
// Each source has a bound of its own, but the targets at which these are met differ: where two sources differ by a
// fault each, a target of both has both. The bound is looked for over the components whose best mode is not the same in
// all sources, by branch and bound; the others are taken at their best.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/reasoning/estimate/combination.hpp"
#include "runtime/reasoning/estimate/extensions.hpp"

namespace rmpl::runtime {

/// A tracked mode combination with its clocks and where it may go.
struct Source {
  const automata::Modes* modes;
  std::span<const Clocked> clocks;  ///< at least one
  double weight;                    ///< the sum of `weight_of` over its clocks
  Extensions* extensions;           ///< with moves that are, for each component, the best of all clocks
  /// The components whose moves differ from clock to clock, ascending, and their moves, clock by clock.
  std::span<const std::size_t> varied = {};
  std::span<const ComponentMoves* const> moves = {};
  /// One by the share of the outcomes that are possible, by clock; where there is one only, of all clocks. What is not
  /// known is 1; then outcomes are worth more by a factor of `slack`, at most.
  std::span<const double> scales = {};
  double slack = 1;
  std::span<const std::size_t> differing = {};  ///< the components whose clocks are not the same in all of `clocks`
  std::span<const std::size_t> restarted = {};  ///< the components whose clocks restarts start anew, ascending

  /// Whether the clock of the component goes on where it stays in its mode.
  [[nodiscard]] bool goes_on(std::size_t component) const {
    return !std::binary_search(restarted.begin(), restarted.end(), component);
  }

  [[nodiscard]] double weight_of(std::size_t clock) const {
    if (scales.empty()) return clocks[clock].probability;
    return clocks[clock].probability * scales[scales.size() > 1 ? clock : 0];
  }
  /// Of a clock, into these modes: times what its own moves of the varied components promise.
  [[nodiscard]] double weight_into(std::size_t clock, const automata::Modes& to) const {
    double result = weight_of(clock);
    for (std::size_t v = 0; v < varied.size() && result > 0; ++v) {
      result *= moves[clock * varied.size() + v]->prior(to[varied[v]]);
    }
    return result;
  }
};

class JointBound {
 public:
  /// Before `reaches`, and again where the sources were tightened.
  void look_at(std::span<const Source> sources);
  /// Whether a target to which each source gives its `fronts` at most may be worth `enough`; true as well where telling
  /// would take too long: up to `nodes` sums over all sources.
  bool reaches(std::span<const double> fronts, double enough, std::size_t nodes);
  /// Whether the last question would have taken longer, and how many sums are left of those that it might take.
  [[nodiscard]] bool undecided() const { return nodes_ == 0; }
  [[nodiscard]] std::size_t nodes_left() const { return nodes_; }

 private:
  /// A component, and for each mode that is best in some source: by source, what the best becomes there, as a factor.
  struct Contested {
    std::vector<std::vector<double>> options;
    double dissent = 0;  ///< weight of the sources whose best mode is not that of the first
  };

  /// The best of a component in one source, and what it promises.
  struct Best {
    automata::ModeId mode;
    double promise = 0;
  };

  static Best best(const Source& source, std::size_t component);
  void contest(std::span<const Source> sources, std::size_t component);
  bool reaches(std::size_t depth);

  std::vector<Decision> excluded_;            ///< modes that are known to be impossible by themselves, sorted
  std::vector<Best> bests_;                   ///< by source, of the component that is being looked at
  std::vector<Contested> contested_;          ///< those that tell most sources apart first
  std::vector<std::vector<double>> promise_;  ///< by depth, by source
  std::span<const double> fronts_;
  double enough_ = 0;
  std::size_t nodes_ = 0;  ///< that may still be looked at
};

}  // namespace rmpl::runtime
