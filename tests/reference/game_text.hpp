// The answer of the game of plans in words.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tests/reference/game.hpp"

namespace rmpl::reference {

/// `sure, lasts`.
std::string to_text(const Level& level);
/// The entries that are not zero.
std::string to_text(const GameCost& cost);
/// The run that the strategy hopes for, one action or wait a line, up to where the target is reached or nothing happens
/// any more; then what is sent there.
std::string main_line(Board& board, const Game& game, Node start);
/// What is done for reward in a node where the goal is kept, one action a line, likewise.
std::string pursuit_line(Board& board, const Game& game, Node node);
/// Every node with its modes, its action and where that leads.
std::string whole(Board& board, const Game& game, Node start);

}  // namespace rmpl::reference
