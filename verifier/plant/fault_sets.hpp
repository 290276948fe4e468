// Sets of faults: which faults a run has had, where it matters which, not only how many.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "verifier/property/fault.hpp"

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

/// The sets met so far, by number; 0 is the empty one.
class FaultSets {
 public:
  FaultSets() { number({}); }

  [[nodiscard]] const FaultSet& operator[](unsigned number) const { return *sets_[number]; }
  /// The set after a step from some modes to others with so many faults.
  unsigned after(unsigned before, const automata::Plant& plant, const automata::Modes& from, const automata::Modes& to,
                 unsigned faults);

 private:
  unsigned number(FaultSet set);

  std::map<FaultSet, unsigned> numbers_;
  std::vector<const FaultSet*> sets_;  ///< the keys of `numbers_`
};

}  // namespace rmpl::verifier
