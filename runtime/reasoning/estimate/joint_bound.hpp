// What several sources together can still give to one target that was not found yet.
//
// Each source has a bound of its own, but the targets at which these are met differ: where two sources differ by a
// fault each, a target of both has both. The bound is looked for over the components whose best mode is not the same in
// all sources, by branch and bound; the others are taken at their best.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/reasoning/estimate/source.hpp"

namespace rmpl::runtime {

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
