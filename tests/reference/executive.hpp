// The executive, by the letter of semantics 5: what it may do in a state under a goal, worked out by looking at every
// state and every command.
//
// Derived, so that nothing else is allowed:
// - no goal asks for nothing, and without a plan all controls are idle, or what is nearest to that of what the model
//   tolerates;
// - *no plan*, where no permitted commands lead to the goal whatever is hoped for; and that there is one, where some do
//   with one thing happening at a time;
// - nothing is commanded where the goal is entailed and nothing is to be gained;
// - what each command on the way leads nearer to: no way takes more cycles than the shortest on which one thing happens
//   at a time, where what the goal names lasts and no two components may go on in time by themselves.
//
// Left open, and looked at only as far as is said:
// - which of several ways; a wait for what comes at once before anything else is done; how long ways to what does not
//   last are, as durations are not compared; plans by coincidence or by chance;
// - what a goal has and loses at once is not looked after: there the rest may be gone for; and a wait that leads on may
//   come before the irreversible step on which the plan fails;
// - irreversible steps that come later by themselves, where some outcome of the command, or an interconnection, does
//   without them;
// - for reward: that it may be done, not that it must be: it keeps what the goal has and takes no forbidden step, and
//   leads to where some component is worth more, or holds something back while the goal is waited for; whether a
//   command serves the goal or a reward, where it may be for either.
//
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "automata/state.hpp"
#include "tests/reference/courses.hpp"
#include "tests/reference/plans.hpp"

namespace rmpl::reference {

/// What the executive says to modes and goal.
struct Advice {
  bool no_plan = false;
  automata::ControlAction action;
  bool for_reward = false;  ///< a command that no part of the goal needs
  auto operator<=>(const Advice&) const = default;
};

/// Remembers what it was asked. Keeps a reference to the step.
class Executive {
 public:
  using Goal = std::vector<automata::Assignment>;  ///< modes that are asked for
  explicit Executive(const Step& step) : courses_(step) {}

  /// At least one; where it is one, the rules leave no choice. The state is possible.
  const std::set<Advice>& allowed(const automata::Modes& modes, const Goal& goal);

 private:
  [[nodiscard]] Advice advice(std::size_t action, bool for_reward) const;
  /// What the goal needs, where it is not entailed.
  std::set<Advice> needed(std::size_t state, Plans& plans, const Goal& goal);
  /// What is looked at first: the parts of a goal but for those that are achieved and lost at once, which nothing
  /// keeps, and those that always are.
  Goal put_off(std::size_t state, const Goal& goal);
  bool is_lost_at_once(std::size_t state, const automata::Assignment& part);
  bool moves_at_once(std::size_t state);
  /// Whether, with nothing done before that, several components may leave their modes in time at once: of ways a safe
  /// one goes first.
  bool waits_are_unsafe(std::size_t state);
  bool is_housekeeping(std::size_t state, std::size_t action, Plans& plans, const Goal& goal);
  /// Whether an action takes away nothing that the goal has, and no hope of it.
  bool keeps(std::size_t state, std::size_t action, Plans& plans, const Goal& goal);
  [[nodiscard]] bool has(std::size_t state, const automata::Assignment& part) const;
  [[nodiscard]] bool is_worth_more(std::size_t state, std::size_t than) const;
  Plans& plans_of(const Goal& goal);

  Courses courses_;
  std::map<Goal, Plans> plans_;
  std::map<std::pair<std::size_t, Goal>, std::set<Advice>> allowed_;
};

}  // namespace rmpl::reference
