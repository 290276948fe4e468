// What bars the way where a game has no strategy.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "runtime/reasoning/game/game.hpp"

namespace rmpl::runtime {

/// The harm that no strategy may do, on the least costly run to the goal that does harm: the first on it. Nothing where
/// no run at all leads from the node to the goal.
std::optional<Game::HarmOf> barrier(const Game& game, std::uint32_t start);

}  // namespace rmpl::runtime
