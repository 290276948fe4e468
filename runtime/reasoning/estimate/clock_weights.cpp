// Sums over clocks, each worked out once.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/clock_weights.hpp"

#include <algorithm>

namespace rmpl::runtime {

void ClockWeights::begin(std::size_t sources) {
  if (known_.size() < sources) known_.resize(sources);
  for (Known& known : known_) known.size = 0;
}

const ClockWeights::Weights& ClockWeights::into(std::size_t number, const Source& source,
                                                const automata::Modes& target) {
  Known& known = known_[number];
  const auto leads_there = [&](const Weights& weights) {
    return std::equal(source.varied.begin(), source.varied.end(), weights.to.begin(), weights.to.end(),
                      [&](std::size_t c, automata::ModeId mode) { return target[c] == mode; });
  };
  const auto end = known.weights.begin() + static_cast<std::ptrdiff_t>(known.size);
  if (const auto found = std::find_if(known.weights.begin(), end, leads_there); found != end) return *found;
  if (known.size == known.weights.size()) known.weights.emplace_back();
  Weights& fresh = known.weights[known.size++];
  fresh.to.clear();
  for (const std::size_t c : source.varied) fresh.to.push_back(target[c]);
  fresh.by_clock.clear();
  fresh.sum = 0;
  for (std::size_t e = 0; e < source.clocks.size(); ++e) {
    fresh.by_clock.push_back(source.weight_into(e, target));
    fresh.sum += fresh.by_clock.back();
  }
  return fresh;
}

}  // namespace rmpl::runtime
