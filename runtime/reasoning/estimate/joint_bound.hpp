// What several sources together can still give to one target that was not found yet.
//
// Each source has a bound of its own, but the targets at which these are met differ: where two sources differ by a
// fault each, a target of both has both; and where clocks count, a fault that came now is not one that came before. The
// bound is looked for over the components whose best mode, or its clock, is not the same in all sources, by branch and
// bound; the others are taken at their best.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/reasoning/estimate/belief.hpp"
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
  /// Before `reaches`, and again where the sources were tightened. The step ends at `now`.
  void look_at(std::span<const Source> sources, const Clocks& clocks, automata::Ticks now);
  /// Whether a target to which each source gives its `fronts` at most may be worth `enough`; true as well where telling
  /// would take too long: up to `nodes` sums over all sources.
  bool reaches(std::span<const double> fronts, double enough, std::size_t nodes);
  /// Whether the last question would have taken longer, and how many sums are left of those that it might take.
  [[nodiscard]] bool undecided() const { return nodes_ == 0; }
  [[nodiscard]] std::size_t nodes_left() const { return nodes_; }

 private:
  /// Where a component may be after the step, and since when.
  struct Place {
    automata::ModeId mode;
    automata::Ticks start;
    bool operator==(const Place&) const = default;
  };
  /// A component, and for each place of it: by source, what the best becomes there, as a factor.
  struct Contested {
    std::vector<std::vector<double>> options;
    double dissent = 0;  ///< weight of the sources whose best place is not that of the first
  };

  /// The best of a component in one source, and what it promises.
  struct Best {
    Place place;
    double promise = 0;
  };

  template <class PlaceOf>
  static Best best(const Source& source, std::size_t component, const PlaceOf& place);
  template <class PlaceOf>
  void contest(std::span<const Source> sources, std::size_t component, const PlaceOf& place);
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
