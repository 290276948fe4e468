// A program with its plant, in sampled time, as a Markov chain.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
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
  Prospect prospect(StateNumber state) override { return states_[state].prospect; }
  [[nodiscard]] std::size_t states() const override { return states_.size(); }

 private:
  struct State {
    LoopStateId loop;
    unsigned faults = 0;
    std::vector<Units> ages;      ///< by component
    std::vector<Units> readings;  ///< by group of clocks
    std::vector<Units> longest;   ///< of groups, then of components
    InState in_state;
    Prospect prospect;
    std::int8_t wanted = -1;  ///< below 0: not asked yet
  };
  /// Where the loop comes to while the clocks of the program stay in their cells.
  struct Follower {
    LoopStateId loop;
    std::vector<std::size_t> sources;  ///< as `Outcome` has them
  };
  /// A cycle of the loop, whatever clocks read.
  struct Cycle {
    StepDraws draws;
    std::vector<bool> restarted;  ///< by component: a restart starts its clock anew
    std::unordered_map<automata::Modes, Follower, automata::ModesHash> followers;  ///< looked up, never iterated
  };

  [[nodiscard]] const std::vector<Units>& longest(StateNumber state) const override { return states_[state].longest; }
  [[nodiscard]] const InState& in_state(StateNumber state) const override { return states_[state].in_state; }
  Settled settle(StateNumber state, const std::vector<Units>& readings) override;
  /// The cells of the groups there, in steps.
  const std::vector<Interval>& cells(LoopStateId at);
  /// Where the loop is with each group in the cell of its reading. `groups`: which of those before these are.
  LoopStateId go_on(LoopStateId at, const std::vector<Units>& readings, std::vector<std::size_t>& groups);
  /// The state with each group in the cell of its reading. `apart` becomes the groups that are kept apart, as positions
  /// in `at`.
  StateNumber enter(LoopStateId at, const std::vector<Units>& readings, std::vector<Units> ages, unsigned faults,
                    std::vector<std::size_t>& apart);
  /// None where no command is permitted.
  Cycle* cycle(LoopStateId at);
  /// Sees to it that what follows in these modes is known.
  void follow_all(LoopStateId at, Cycle& cycle, const std::vector<Draw>& draws);
  Branch branch_to(const State& state, const automata::Modes& here, const std::vector<bool>& restarted,
                   const Follower& follower, const Draw& draw);

  Loop& loop_;
  automata::PlantStep& step_;
  const Walked& walked_;
  bool long_clocks_;
  Meter& meter_;
  Ages ages_;
  ListNumbers numbers_;
  std::vector<State> states_;
  std::vector<std::optional<std::vector<Interval>>> cells_;    ///< by state of the loop
  std::vector<std::optional<std::unique_ptr<Cycle>>> cycles_;  ///< likewise; null: no command is permitted
  std::vector<Row> rows_;
};

}  // namespace rmpl::verifier
