// What a search for the next mode combinations goes out from.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

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

  /// The probability of all that follows.
  [[nodiscard]] double following() const;
  /// An upper bound of the worth of all that follows. What holds for the best moves of all clocks would be too much.
  [[nodiscard]] double greatest_worth() const;
};

}  // namespace rmpl::runtime
