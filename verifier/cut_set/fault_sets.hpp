// Sets of faults: which faults a run has had, where it matters which, not only how many.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "verifier/property/fault.hpp"
#include "verifier/search/system.hpp"

namespace rmpl::verifier {

/// The faults of a run, sorted, each once; and how many there were, repetitions counted.
struct FaultSet {
  std::vector<Fault> faults;
  unsigned count = 0;
  auto operator<=>(const FaultSet&) const = default;
};

/// Whether all of `a` is in `b`.
bool subset(const FaultSet& a, const FaultSet& b);
/// The order in which sets of faults are told, for whatever has `faults`: small ones first, then by component and mode.
inline constexpr auto told_before = [](const auto& a, const auto& b) {
  return a.faults.size() != b.faults.size() ? a.faults.size() < b.faults.size() : a.faults < b.faults;
};

/// Sets of faults, asked whether one of them is within another set: a tree of their sorted faults (I. Savnik: Index
/// Data Structure for Fast Subset and Superset Queries, 2013). A question costs no more than there are subsets of what
/// is asked, nor than there are faults in the sets held, times the logarithm of how many.
class FaultSetTree {
 public:
  void add(const std::vector<Fault>& set);
  /// Whether a set that was added is a subset.
  [[nodiscard]] bool holds_subset_of(const std::vector<Fault>& set) const { return find(set, false); }
  /// Whether another set that was added is.
  [[nodiscard]] bool holds_proper_subset_of(const std::vector<Fault>& set) const { return find(set, true); }

 private:
  struct Node {
    std::map<Fault, std::uint32_t> next;
    bool ends = false;  ///< a set
  };

  [[nodiscard]] bool find(const std::vector<Fault>& set, bool proper) const;

  std::vector<Node> nodes_{1};
};

/// The sets met so far, by number; 0 is the empty one.
class FaultSets {
 public:
  FaultSets() { number({}); }

  [[nodiscard]] const FaultSet& operator[](unsigned number) const { return *sets_[number]; }
  /// None is less for a subset with no more faults: how many there were, and between which the faults are.
  [[nodiscard]] TransitionSystem::FaultMeasures measures(unsigned number) const;
  /// The set after a step from some modes to others with so many faults.
  unsigned after(unsigned before, const automata::Plant& plant, const automata::Modes& from, const automata::Modes& to,
                 unsigned faults);

 private:
  unsigned number(FaultSet set);

  std::map<FaultSet, unsigned> numbers_;
  std::vector<const FaultSet*> sets_;  ///< the keys of `numbers_`
};

}  // namespace rmpl::verifier
