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

#include "runtime/reasoning/estimate/extensions.hpp"

namespace rmpl::runtime {

/// A tracked state with its probability and where it may go.
struct Source {
  const automata::SystemState* state;
  double weight;
  Extensions* extensions;
};

class JointBound {
 public:
  /// Before `reaches`, and again where the sources were tightened.
  void look_at(std::span<const Source> sources);
  /// Whether a target to which each source gives its `fronts` at most may be worth `enough`; true as well where telling
  /// would take too long. Up to some 500 sums over all sources.
  bool reaches(std::span<const double> fronts, double enough);

 private:
  /// A component, and for each of the modes that it may be in: by source, what the best becomes there, as a factor.
  struct Contested {
    std::vector<std::vector<double>> options;
    double dissent = 0;  ///< weight of the sources whose best mode is not that of the first
  };

  void contest(std::span<const Source> sources, std::size_t component);
  bool reaches(std::size_t depth);

  std::vector<Contested> contested_;          ///< those that tell most sources apart first
  std::vector<std::vector<double>> promise_;  ///< by depth, by source
  std::span<const double> fronts_;
  double enough_ = 0;
  std::size_t nodes_ = 0;  ///< that may still be looked at
};

}  // namespace rmpl::runtime
