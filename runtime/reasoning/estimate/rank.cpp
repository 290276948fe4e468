// Ranks of probabilities.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/rank.hpp"

#include <algorithm>
#include <cmath>

namespace rmpl::runtime {
namespace {

double probability_of(std::uint64_t rank) { return std::pow(10.0, -static_cast<double>(rank)); }

}  // namespace

std::uint64_t rank_of(double probability) {
  return static_cast<std::uint64_t>(std::max(0LL, std::llround(-std::log10(probability))));
}

void rank(std::vector<automata::Move>& moves) {
  for (automata::Move& move : moves) move.probability = probability_of(rank_of(move.probability));
}

void rank(std::vector<std::vector<automata::Move>>& moves) {
  for (auto& component : moves) rank(component);
}

std::uint64_t count_from_best(Combinations& belief) {
  if (belief.empty()) return 0;
  const std::uint64_t best = rank_of(belief.front().probability);
  for (Combination& entry : belief) {
    entry.probability = entry.clocks.front().probability = probability_of(rank_of(entry.probability) - best);
  }
  return best;
}

}  // namespace rmpl::runtime
