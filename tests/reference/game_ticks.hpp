// The positions of the game of plans cycle by cycle: modes, and how old each is exactly.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "tests/reference/game_ages.hpp"

namespace rmpl::reference {

/// The true game, in which the executive knows every age and chooses anew in every cycle: no strategy is better than
/// its best. A node is the modes and the ages in cycles, as far as they matter; no action is a wait. For bounds of a
/// few cycles.
class TickArena final : public Arena {
 public:
  using Ages = std::vector<std::int64_t>;

  /// `cycle` in ticks, above 0.
  TickArena(GameStep& step, std::int64_t cycle) : Arena(step), cycle_(cycle) {}

  /// All modes were entered just now.
  Node start(const automata::Modes& modes) override { return number({modes, Ages(modes.size())}); }
  Node number(std::pair<automata::Modes, Ages> key);
  [[nodiscard]] const automata::Modes& modes(Node node) const override { return nodes_[node]->first; }
  [[nodiscard]] const Ages& ages(Node node) const { return nodes_[node]->second; }
  std::optional<Turn> turn(Node node, GameStep::Action action) override;

 private:
  std::int64_t cycle_;
  std::map<std::pair<automata::Modes, Ages>, Node> numbers_;
  std::vector<const std::pair<automata::Modes, Ages>*> nodes_;
};

}  // namespace rmpl::reference
