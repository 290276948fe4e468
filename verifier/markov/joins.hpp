// Where what a component does is not told apart, as nothing that follows depends on it.
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <vector>

#include "verifier/markov/list_numbers.hpp"

namespace rmpl::verifier {

/// A component is *joined* where states of the loop that differ in its mode, or in its clock, count as one. That is
/// tried wherever its clock decides what it does. Where the states turn out to differ in more than that, it has been
/// joined in vain, there and wherever that came from.
class Joins {
 public:
  /// A component, in a marking and modes of others, as a list of numbers.
  using Spot = std::uint32_t;
  Spot spot(const ListNumbers::List& list);

  [[nodiscard]] bool is_barred(Spot spot) const { return barred_[spot]; }
  void bar(Spot spot) { barred_[spot] = true; }
  /// A component that is joined at one spot is joined at the next.
  void leads(Spot from, Spot to) {
    if (from != to) before_[to].insert(from);
  }
  /// What is joined there differs.
  void fails(Spot spot) { failed_.push_back(spot); }
  /// Bars what has failed since the last call, with all that led there. Whether there was any.
  bool learn();

 private:
  ListNumbers numbers_;
  std::vector<bool> barred_;
  std::vector<std::set<Spot>> before_;
  std::vector<Spot> failed_;
};

}  // namespace rmpl::verifier
