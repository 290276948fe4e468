// A game over some components, with what was solved of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "runtime/reasoning/game/arena.hpp"
#include "runtime/reasoning/game/game.hpp"
#include "runtime/reasoning/game/rewards.hpp"
#include "runtime/reasoning/game/solve.hpp"

namespace rmpl::runtime {

struct PlayedGame {
  std::shared_ptr<Arena> arena;
  std::shared_ptr<const Game> game;
  std::unordered_map<std::uint32_t, std::shared_ptr<const Solution>> solutions = {};  ///< by start, where it counts
  bool best = true;                           ///< else only useful actions were looked at
  std::shared_ptr<GameRewards> rewards = {};  ///< once they were asked for
};

}  // namespace rmpl::runtime
