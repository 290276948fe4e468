// A program with its plant, in sampled time, as a Markov chain.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "verifier/closed_loop/loop.hpp"
#include "verifier/markov/joins.hpp"
#include "verifier/markov/loop_cycles.hpp"
#include "verifier/markov/outlook.hpp"
#include "verifier/markov/plant_process.hpp"

namespace rmpl::verifier {

/// In place of the age of a component: nobody knows it, and perhaps not the mode either.
inline constexpr Units joined = -2;

/// States are those of the loop (closed_loop/loop.hpp), with readings of component clocks and of the program clocks
/// that have not far to go; the others are long. A run ends with the program.
///
/// States that differ only in what some components are in the middle of, or how long, count as one where all that
/// follows is the same: from each of them the other components step alike, what comes next differs in no more than
/// that, and the same is so again of what comes next. That is looked at step by step, for as far as runs are followed.
///
/// All states in which what is wanted holds are one, as runs are followed no further. So are states of which an outlook
/// tells how likely each step from now on is to come there, if it is alike: only that one follows them.
class LoopProcess final : public LongClocks {
 public:
  /// Keeps references. `long_clocks`: whether clocks that run for long are kept apart, or are part of states as well;
  /// `joins`: whether states count as one; `outlook`: null where there is none.
  LoopProcess(Loop& loop, automata::PlantStep& step, const Walked& walked, bool long_clocks, bool joins,
              Outlook* outlook, Meter& meter);

  std::vector<Start> initial() override;
  const std::vector<Row>& rows(StateNumber state, Real less_likely_than) override;
  bool wanted(StateNumber state) override { return end_ == state; }
  Prospect prospect(StateNumber state) override { return states_[state].prospect; }
  bool tells_more_apart() override;
  [[nodiscard]] std::size_t states() const override { return states_.size(); }

 private:
  struct State {
    std::vector<LoopStateId> places;  ///< the loop is in one of these, ascending; none: see `hazard`
    unsigned faults = 0;
    std::vector<Units> ages;      ///< by component
    std::vector<Units> readings;  ///< by group of clocks
    std::vector<Units> longest;   ///< of groups, then of components
    InState in_state;
    Prospect prospect;
    Enclosure hazard{};  ///< where there are no places: how likely a step is to come to what is wanted
  };
  using Cycles = std::vector<LoopCycles::Cycle*>;  ///< by place

  [[nodiscard]] const std::vector<Units>& longest(StateNumber state) const override { return states_[state].longest; }
  [[nodiscard]] const InState& in_state(StateNumber state) const override { return states_[state].in_state; }
  Settled settle(StateNumber state, const std::vector<Units>& readings) override;
  /// The state with each group in the cell of its reading. `apart` becomes the groups that are kept apart, as positions
  /// in `places`.
  StateNumber enter(std::vector<LoopStateId> places, const std::vector<Units>& readings, std::vector<Units> ages,
                    unsigned faults, std::vector<std::size_t>& apart);

  /// Where all of them have the same steady hazard.
  std::optional<Enclosure> steady_hazard(const std::vector<LoopStateId>& places);
  void stop_idle_clocks(const std::vector<LoopStateId>& places, std::vector<Units>& ages);
  StateNumber add_known(const Prospect& prospect, const Enclosure& hazard);
  StateNumber enter_steady(const Enclosure& hazard);
  StateNumber enter_end();
  void leave_steady(StateNumber state);

  /// The cycles that start there; nothing where the places differ in more than what is joined.
  std::optional<Cycles> cycles_of(const std::vector<LoopStateId>& places, const std::vector<Units>& ages);
  /// Components to be joined from there on.
  std::vector<std::size_t> to_join(const State& state, const Cycles& cycles);
  Joins::Spot spot(std::size_t component, const State& state);
  /// Where the loop comes to, and the components whose clocks nobody knows.
  struct Next {
    std::vector<LoopStateId> places;
    const std::vector<std::size_t>* sources = nullptr;
    std::vector<bool> clocks_unknown;  ///< by component
    bool wanted = false;               ///< what is wanted holds there
  };
  /// What may be drawn where the clocks of all components have been asked.
  struct Outcome {
    Draw draw;
    Prospect prospect;
    Real worth = 1;  ///< it comes to what is wanted no more likely than that
    bool followed = false;
    std::optional<Next> next;  ///< of one that is followed; nothing where that differs in more than what is joined
  };
  struct Part {
    Real less_likely_than = 0;      ///< outcomes of less are left out
    std::vector<Outcome> outcomes;  ///< possible ones, the likelier first
    std::vector<Real> rest;         ///< of the outcomes from one on, and of what is left out
    bool impossible = false;        ///< there are others
    bool differs = false;           ///< what is possible differs in more than what is joined
  };
  [[nodiscard]] std::vector<automata::Modes> alternatives(const Cycles& cycles, std::size_t place,
                                                          const std::vector<Units>& ages,
                                                          const automata::Modes& drawn) const;
  Part& part(const State& state, const Cycles& cycles, const std::vector<Units>& ages, const automata::Modes& timed,
             const LeftOut& left_out);
  Part work_out(const Cycles& cycles, const std::vector<Units>& ages, const automata::Modes& timed,
                const LeftOut& left_out);
  /// Sees to it that it is known where outcomes lead to.
  void find_next(const State& state, const Cycles& cycles, const std::vector<Units>& ages,
                 const std::vector<Outcome*>& outcomes);
  std::optional<Next> next(const State& state, const Cycles& cycles, const std::vector<Units>& ages,
                           const automata::Modes& drawn);
  Branch branch_to(const State& state, const Cycles& cycles, const Next& next, const Enclosure& probability,
                   unsigned faults);
  /// Nothing where what follows differs in more than what is joined.
  std::optional<Row> row(const State& state, const Cycles& cycles, const std::vector<Units>& ages,
                         const LeftOut& left_out, Real less_likely_than);
  void note_joined(const State& state, const std::vector<Units>& ages, const Row& row);

  Loop& loop_;
  automata::PlantStep& step_;
  const Walked& walked_;
  bool long_clocks_;
  bool joins_wanted_;
  Meter& meter_;
  Ages ages_;
  LoopCycles cycles_;
  Joins joins_;
  ListNumbers numbers_;
  std::vector<State> states_;
  std::map<std::pair<Real, Real>, StateNumber> steady_;  ///< by hazard
  std::optional<StateNumber> end_;                       ///< what is wanted: a run ends there
  ListNumbers part_numbers_;
  std::vector<std::unique_ptr<Part>> parts_;
  std::vector<Row> rows_;
};

}  // namespace rmpl::verifier
