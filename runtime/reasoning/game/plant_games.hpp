// What the games on one plant have in common, whatever their goals.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/game/game.hpp"

namespace rmpl::runtime {

/// Shared by the strategists of one plant, so that a new goal does not ask again. Keeps a reference.
class PlantGames {
 public:
  explicit PlantGames(const automata::PlantStep& step);

  /// Whether the constraints of an island may exclude modes or commands.
  bool excludes(std::size_t island);
  /// Whether a game of all actions over modes was too large before, with these components from these modes: what can be
  /// done does not depend on the goal.
  [[nodiscard]] bool is_large(const Arena& arena, const automata::Modes& modes) const;
  /// A game of all actions over modes was played from these modes.
  void note(const Game& game, const automata::Modes& modes);

 private:
  /// Components of the arena, those on which it rests, the modes of both.
  struct Start {
    std::vector<automata::ComponentId> components, context;
    automata::Modes modes;
    auto operator<=>(const Start&) const = default;
  };
  [[nodiscard]] static Start start_of(const Arena& arena, const automata::Modes& modes);

  const automata::PlantStep& step_;
  std::vector<std::optional<bool>> excludes_;  ///< by island, once asked
  std::set<Start> large_;
};

}  // namespace rmpl::runtime
