// Breadth-first search over the markings of a model program.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "automata/step/marking_step.hpp"
#include "verifier/search/limits.hpp"

namespace rmpl::verifier {

/// What is looked for, in steps.
struct MarkingTarget {
  std::function<bool(const automata::Marking&)> accepts;
  std::uint64_t first = 0;             ///< it counts from this step on
  std::optional<std::uint64_t> last;   ///< and up to this one
  std::optional<unsigned> improbable;  ///< the most improbable draws on the way
};

struct MarkingFound {
  struct State {
    automata::Marking marking;
    std::size_t command = 0;  ///< of those that are free, the one that led here
  };
  /// With fewest steps, of such ways one with fewest improbable draws, and of these one with fewest values off idle;
  /// empty where there is none.
  std::vector<State> path;
  unsigned improbable = 0;  ///< draws on it
  bool startless = false;   ///< no start is consistent
  bool stuck = false;       ///< some marking that was looked at has no next one, whatever is commanded
  bool cut = false;         ///< something was left out as it takes too many improbable draws
};

/// Each marking is looked at once (with a bound on improbable draws: once for each smaller number of them); before
/// `first` once a step. Throws LimitReached, automata::TooManyOutcomes.
MarkingFound find_marking(automata::MarkingStep& step, const std::vector<automata::Command>& free,
                          const MarkingTarget& target, Meter& meter);

}  // namespace rmpl::verifier
