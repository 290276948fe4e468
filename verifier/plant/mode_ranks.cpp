// Ranks of modes, by the transitions of each component alone.
// SPDX-License-Identifier: MIT
#include "verifier/plant/mode_ranks.hpp"

#include <algorithm>
#include <utility>

namespace rmpl::verifier {
namespace {

/// The modes that can be come to, each after all that lead to it, but for what leads back.
class Unwound {
 public:
  Unwound(const automata::Component& component, automata::ModeId start)
      : component_(component), met_(component.modes.size(), Met::not_yet), ranks_(component.modes.size(), 0) {
    follow(start);
    for (auto mode = left_.rbegin(); mode != left_.rend(); ++mode) {
      for (const auto& [from, to] : onward_) {
        if (from == *mode) ranks_[to.index()] = std::max(ranks_[to.index()], ranks_[from.index()] + 1);
      }
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> ranks() && { return std::move(ranks_); }

 private:
  enum class Met { not_yet, on_the_way, left };

  void follow(automata::ModeId mode) {
    met_[mode.index()] = Met::on_the_way;
    for (const automata::Transition& t : component_.transitions) {
      if (t.from != mode || met_[t.to.index()] == Met::on_the_way) continue;
      onward_.emplace_back(mode, t.to);
      if (met_[t.to.index()] == Met::not_yet) follow(t.to);
    }
    met_[mode.index()] = Met::left;
    left_.push_back(mode);
  }

  const automata::Component& component_;
  std::vector<Met> met_;
  std::vector<automata::ModeId> left_;
  std::vector<std::pair<automata::ModeId, automata::ModeId>> onward_;
  std::vector<std::uint32_t> ranks_;
};

}  // namespace

ModeRanks::ModeRanks(const automata::Plant& plant, const automata::Modes& start) {
  for (std::size_t c = 0; c < start.size(); ++c) ranks_.push_back(Unwound(plant.components[c], start[c]).ranks());
}

std::uint32_t ModeRanks::sum(const automata::Modes& modes) const {
  std::uint32_t result = 0;
  for (std::size_t c = 0; c < modes.size(); ++c) result += ranks_[c][modes[c].index()];
  return result;
}

}  // namespace rmpl::verifier
