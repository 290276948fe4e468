// A program with its plant, in sampled time, as a Markov chain.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "verifier/closed_loop/loop.hpp"
#include "verifier/markov/plant_process.hpp"

namespace rmpl::verifier {

/// States are those of the loop (closed_loop/loop.hpp), with readings of component clocks and of the program clocks
/// that have not far to go; the others are long. A run ends with the program.
class LoopProcess final : public LongClocks {
 public:
  /// Keeps references. `long_clocks`: whether clocks that run for long are kept apart, or are part of states as well.
  LoopProcess(Loop& loop, automata::PlantStep& step, const Walked& walked, bool long_clocks, Meter& meter);

  std::vector<Start> initial() override;
  const std::vector<Row>& rows(StateNumber state, Real less_likely_than) override;
  bool wanted(StateNumber state) override;
  [[nodiscard]] std::size_t states() const override { return states_.size(); }

 private:
  struct State {
    LoopStateId loop;
    unsigned faults = 0;
    std::vector<Units> ages;      ///< by component
    std::vector<Units> readings;  ///< by group of clocks
    std::vector<Units> longest;   ///< of groups, then of components
    std::int8_t wanted = -1;      ///< below 0: not asked yet
  };

  [[nodiscard]] const std::vector<Units>& longest(StateNumber state) const override { return states_[state].longest; }
  Settled settle(StateNumber state, const std::vector<Units>& readings) override;
  /// The state with each group in the cell of its reading. `apart` becomes the groups that are kept apart, as positions
  /// in `state`.
  StateNumber enter(LoopState state, const std::vector<Units>& readings, std::vector<Units> ages, unsigned faults,
                    std::vector<std::size_t>& apart);
  Branch branch_to(const State& state, const LoopState& here, const automata::AllEnabled& enabled,
                   const Outcome& outcome, const Draw& draw);

  Loop& loop_;
  automata::PlantStep& step_;
  const Walked& walked_;
  bool long_clocks_;
  Meter& meter_;
  Ages ages_;
  ListNumbers numbers_;
  std::vector<State> states_;
  std::vector<Row> rows_;
};

}  // namespace rmpl::verifier
