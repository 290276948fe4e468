// One game that is under way, and what is expected of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/reasoning/game/rewards.hpp"
#include "runtime/reasoning/game/strategist.hpp"

namespace rmpl::runtime {

/// One game that is under way: for parts of the goal, or for a reward.
class Course {
 public:
  explicit Course(const SolvedGame& solved) : solved_(&solved), game_(*solved.game), start_(solved.start) {}
  explicit Course(const PursuedReward& reward) : reward_(&reward), game_(*reward.game), start_(reward.start) {}

  [[nodiscard]] const Game& game() const { return game_; }
  [[nodiscard]] const Position& position() const { return game_.position(start_); }
  [[nodiscard]] const SolvedGame* solved() const { return solved_; }
  [[nodiscard]] std::uint32_t start() const { return start_; }
  [[nodiscard]] std::uint32_t edge_number(std::uint32_t n) const {
    return solved_ != nullptr ? solved_->solution->at(n).edge : reward_->edge(n);
  }
  [[nodiscard]] const Game::Edge* edge() const {
    const std::uint32_t e = edge_number(start_);
    return e == GameDecision::no_edge ? nullptr : &game_.edges()[e];
  }
  /// Whether it goes on towards a target, and does not only keep what there is.
  [[nodiscard]] bool under_way() const {
    return solved_ == nullptr || solved_->decision().purpose == GameDecision::Purpose::reach;
  }
  [[nodiscard]] bool rests() const {
    const std::uint32_t e = edge_number(start_);
    return e == GameDecision::no_edge || e == game_.nodes()[start_].first;
  }
  [[nodiscard]] automata::ModeId mode(std::uint32_t n, std::size_t member) const {
    return game_.position(n).modes[game_.arena().components()[member].index()];
  }

  /// What may come of a node, what is expected first: of a wait that in which as little as possible comes, of an action
  /// that with which nothing timed coincides; then that of least cost. None where nothing ever happens.
  [[nodiscard]] std::vector<const Game::Outcome*> outcomes(std::uint32_t n) const;
  [[nodiscard]] const Game::Outcome* expected(std::uint32_t n) const {
    const auto all = outcomes(n);
    return all.empty() ? nullptr : all.front();
  }

  /// The node in which the course ends if each action has the expected outcome.
  [[nodiscard]] std::uint32_t end() const;

  /// The open part of the goal that the step of a member serves: the first on whose way it lies, else the first.
  [[nodiscard]] std::size_t open_part(const Strategist& strategist, std::optional<std::size_t> member) const;

 private:
  const SolvedGame* solved_ = nullptr;
  const PursuedReward* reward_ = nullptr;
  const Game& game_;
  std::uint32_t start_;
};

/// The exit that takes a component of the course from its mode to that of a node.
const LocalMoves::Exit* exit_to(const Course& course, const Position::Action& action, std::size_t member,
                                std::uint32_t node);

}  // namespace rmpl::runtime
