// The positions of the game of plans with bounds: modes, and an interval for the age of each.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "tests/reference/game_arena.hpp"

namespace rmpl::reference {

/// In whole cycles since the mode was entered, from least to most; and what the worst run has been charged since then.
struct Age {
  std::int64_t least = 0;
  std::int64_t most = 0;
  std::int64_t charged = 0;
  auto operator<=>(const Age&) const = default;
};

/// The cycle by which the first of the enabled exits is due; where `cycle` is 0, the tick.
std::int64_t first_due(const Freedom& freedom, std::int64_t cycle);
/// The age in cycles, or ticks, from which on nothing changes in a mode; 0 where it has no timed exits.
std::int64_t age_that_matters(const automata::Component& component, automata::ModeId mode, std::int64_t cycle);

/// A node is the modes, and of each component in a mode with timed exits how old it is at least and at most, as far as
/// that can matter: no more than the greatest bound of these exits. Ages of different components are independent: what
/// they have to do with each other is not kept, so that nature may do more than it can.
///
/// A wait ends with what comes first: every set of exits that the intervals allow to come in one cycle before all
/// others is an outcome, with the least and the greatest number of cycles that it may take. The ages of the others have
/// grown by as much, and are below what would have been due.
///
/// What a wait is charged: the greatest number of cycles that it may take, and no more than what a component whose exit
/// is due at some time is left of that, as it was charged since it was entered; one that may be overdue has a cycle. So
/// two things that run beside each other take as long as the longer one, though waits that follow each other end one
/// after the other. Since no run has taken longer than it was charged when a mode was entered, none has when it is
/// left.
///
/// Where the cycle is 0, time is dense: ages are in ticks, actions take none, and what is due at an instant may come
/// before an action or after it. Only then a mode is left for being overdue where it is older than its bound.
class AgedArena final : public Arena {
 public:
  /// `cycle` in ticks.
  AgedArena(GameStep& step, std::int64_t cycle) : Arena(step), cycle_(cycle) {}

  /// Of ages nothing is known but that nothing is overdue that idle controls enable.
  Node start(const automata::Modes& modes) override;
  /// All modes were entered just now.
  Node fresh(const automata::Modes& modes);
  [[nodiscard]] const automata::Modes& modes(Node node) const override { return nodes_[node]->first; }
  [[nodiscard]] const std::vector<Age>& ages(Node node) const { return nodes_[node]->second; }
  [[nodiscard]] bool actions_take_time() const override { return cycle_ > 0; }
  std::optional<Turn> turn(Node node, GameStep::Action action) override;

 private:
  using Key = std::pair<automata::Modes, std::vector<Age>>;

  Node number(Key key);

  std::int64_t cycle_;
  std::map<Key, Node> numbers_;
  std::vector<const Key*> nodes_;
};

}  // namespace rmpl::reference
