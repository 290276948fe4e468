// Symmetry: of all states that differ only in which of several like components does what, one is explored.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>

#include "automata/state.hpp"
#include "verifier/symmetry/automorphisms.hpp"
#include "verifier/zone/zone.hpp"

namespace rmpl::verifier {

/// A group of automorphisms as a sorting rule. Sorting is by small steps that each make the state lexicographically
/// less, first its modes, then its zone: where the group is that of all arrangements of like parts, the usual case, it
/// is a bubble sort. For other groups more than one state of an orbit may be left, which costs states, nothing else.
/// (E. A. Emerson, A. P. Sistla: Symmetry and Model Checking, 1996; M. Hendriks et al.: Adding Symmetry Reduction to
/// Uppaal, 2003, where the user declares it.)
class Symmetry {
 public:
  Symmetry() = default;
  explicit Symmetry(std::vector<Permutation> generators);

  [[nodiscard]] bool trivial() const { return generators_.empty(); }
  /// Whether the two, `a` before `b`, can be exchanged with nothing else changing and no mode renamed.
  [[nodiscard]] bool exchanges(automata::ComponentId a, automata::ComponentId b) const {
    return std::binary_search(exchanges_.begin(), exchanges_.end(), std::pair(a, b));
  }

  /// Sorts a state. `live` are the components of the zone's clocks, after the first `others` of them. Returns the
  /// permutation that was applied if `applied`, else an empty one.
  Permutation sort(automata::Modes& modes, std::vector<automata::ComponentId>& live, std::size_t others, Zone& zone,
                   bool applied) const;

 private:
  std::vector<Permutation> generators_;
  std::vector<std::pair<automata::ComponentId, automata::ComponentId>> exchanges_;  ///< sorted
};

/// The modes under a permutation.
automata::Modes renamed(const automata::Modes& modes, const Permutation& permutation);

}  // namespace rmpl::verifier
