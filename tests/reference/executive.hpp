// What the executive may do in a state under a goal, by the game of plans: every state and every command is looked at.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "automata/state.hpp"
#include "tests/reference/game_ages.hpp"
#include "tests/reference/game_board.hpp"

namespace rmpl::reference {

/// What the executive says to modes and goal.
struct Advice {
  bool no_plan = false;
  automata::ControlAction action;
  bool for_reward = false;  ///< a command that no part of the goal needs
  auto operator<=>(const Advice&) const = default;
};

/// Advice is fit
/// - for no goal, and where permitted actions lead to no state in which the goal holds, commands that have nothing to
///   do with it left out, which would at best pass the time: if it is what is sent where nothing is wanted; only there
///   *no plan* is fit;
/// - where the model excludes all that resting could bring, whatever it is;
/// - else if the action is permitted: it does no harm that could not come anyway; and where the goal can be kept, if
///   the action keeps it, whatever comes of it.
/// Which of several fit actions costs least is the question of the strategies.
///
/// Remembers what it was asked.
class Executive {
 public:
  explicit Executive(const automata::Plant& plant) : step_(plant) {}

  /// The modes are possible. Throws `GameTooLarge`.
  /// Of ages nothing is known.
  bool fits(const automata::Modes& modes, const automata::Formula& goal, const Advice& advice);
  /// What may come of the action, in order.
  std::vector<automata::Modes> outcomes(const automata::Modes& modes, const automata::Formula& goal,
                                        const automata::ControlAction& action);

 private:
  struct Asked {
    AgedArena arena;
    Board board;
    std::set<Node> reached;     ///< what was explored
    std::set<Node> kept;        ///< of these
    std::set<Node> hopeful;     ///< from these the goal can be hoped for
    std::set<std::size_t> own;  ///< controls that have to do with the goal

    Asked(GameStep& step, const automata::Formula& goal);
    void explore(Node node);
  };
  [[nodiscard]] GameStep::Action number(const automata::ControlAction& action) const;

  GameStep step_;
  Asked& asked(const automata::Formula& goal);

  std::vector<std::pair<automata::Formula, std::unique_ptr<Asked>>> asked_;
};

}  // namespace rmpl::reference
