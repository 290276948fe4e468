// Cycles of a closed loop in sampled time, whatever clocks read, as they are asked for.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "verifier/closed_loop/loop.hpp"
#include "verifier/markov/draws.hpp"
#include "verifier/markov/outlook.hpp"

namespace rmpl::verifier {

/// Where the loop comes to while the clocks of the program stay in their cells.
struct Follower {
  LoopStateId loop;
  std::vector<std::size_t> sources;  ///< as `Outcome` has them
};

class LoopCycles {
 public:
  struct Cycle {
    StepDraws draws;
    std::vector<bool> restarted;  ///< by component: a restart starts its clock anew
    std::unordered_map<automata::Modes, Follower, automata::ModesHash> followers;  ///< looked up, never iterated
  };

  /// Keeps references. `outlook`: null where there is none.
  LoopCycles(Loop& loop, automata::PlantStep& step, automata::Ticks period, Outlook* outlook)
      : loop_(loop), step_(step), period_(period), outlook_(outlook) {}

  /// The state of the loop in whose place it is put: components that do not matter are in modes in which they stay.
  LoopStateId at_rest(LoopStateId at);
  /// What may still come of a state.
  const Outlook::Told& told(LoopStateId at);

  /// The cycle that starts there; null where no command is permitted, or the program has ended.
  Cycle* at(LoopStateId at);
  /// Sees to it that what follows in these modes is known.
  void follow(LoopStateId at, Cycle& cycle, const std::vector<automata::Modes>& modes);
  /// The cells of the groups there, in steps.
  const std::vector<Interval>& cells(LoopStateId at);
  /// Where the loop is with each group in the cell of its reading. `groups`: which of those before these are.
  LoopStateId go_on(LoopStateId at, const std::vector<Units>& readings, std::vector<std::size_t>& groups);

 private:
  Loop& loop_;
  automata::PlantStep& step_;
  automata::Ticks period_;
  Outlook* outlook_;
  const Outlook::Told nothing_;
  std::vector<const Outlook::Told*> told_;                     ///< by state of the loop; null: not asked yet
  std::vector<std::optional<LoopStateId>> at_rest_;            ///< likewise
  std::vector<std::optional<std::vector<Interval>>> cells_;    ///< likewise
  std::vector<std::optional<std::unique_ptr<Cycle>>> cycles_;  ///< likewise
};

}  // namespace rmpl::verifier
