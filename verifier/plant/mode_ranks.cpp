// Ranks of modes, by the transitions of each component alone.
// SPDX-License-Identifier: MIT
#include "verifier/plant/mode_ranks.hpp"

#include <algorithm>
#include <utility>

namespace rmpl::verifier {
namespace {

/// A depth-first walk, without recursion: components may have many modes. What leads on from a mode is known once the
/// walk has left it; in the opposite order each mode comes after all that leads to it, but for what leads back. Linear.
std::vector<std::uint32_t> ranks_of(const automata::Component& component, automata::ModeId start) {
  std::vector<std::vector<std::size_t>> next(component.modes.size());
  for (const automata::Transition& t : component.transitions) next[t.from.index()].push_back(t.to.index());
  enum class Met { not_yet, on_the_way, left };
  std::vector<Met> met(next.size(), Met::not_yet);
  std::vector<std::vector<std::size_t>> onward(next.size());
  std::vector<std::size_t> left;
  std::vector<std::pair<std::size_t, std::size_t>> way = {
      {start.index(), 0}};  // modes, and how many ways on were taken
  met[start.index()] = Met::on_the_way;
  while (!way.empty()) {
    const std::size_t mode = way.back().first;
    if (way.back().second == next[mode].size()) {
      met[mode] = Met::left;
      left.push_back(mode);
      way.pop_back();
      continue;
    }
    const std::size_t to = next[mode][way.back().second++];
    if (met[to] == Met::on_the_way) continue;
    onward[mode].push_back(to);
    if (met[to] == Met::left) continue;
    met[to] = Met::on_the_way;
    way.emplace_back(to, 0);
  }
  std::vector<std::uint32_t> ranks(next.size(), 0);
  for (auto mode = left.rbegin(); mode != left.rend(); ++mode) {
    for (const std::size_t to : onward[*mode]) ranks[to] = std::max(ranks[to], ranks[*mode] + 1);
  }
  return ranks;
}

}  // namespace

ModeRanks::ModeRanks(const automata::Plant& plant, const automata::Modes& start) {
  for (std::size_t c = 0; c < start.size(); ++c) ranks_.push_back(ranks_of(plant.components[c], start[c]));
}

std::uint32_t ModeRanks::sum(const automata::Modes& modes) const {
  std::uint32_t result = 0;
  for (std::size_t c = 0; c < modes.size(); ++c) result += ranks_[c][modes[c].index()];
  return result;
}

}  // namespace rmpl::verifier
