// Beliefs: order, sum, most likely plant state.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/belief.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "automata/clock_use.hpp"
#include "runtime/reasoning/estimate/order.hpp"

namespace rmpl::runtime {

void put_in_order(Belief& belief) {
  put_in_order(belief, [](const BeliefEntry& a, const BeliefEntry& b) { return a.state < b.state; });
}

double total(const Belief& belief) {
  return std::accumulate(belief.begin(), belief.end(), 0.0,
                         [](double sum, const BeliefEntry& entry) { return sum + entry.probability; });
}

void normalise(Belief& belief) {
  const double sum = total(belief);
  if (!(sum > 0)) return;
  for (BeliefEntry& entry : belief) entry.probability /= sum;
}

void tell_most_likely(const Belief& belief, Estimate& estimate, base::FunctionRef<void()> go_on) {
  const double sum = total(belief);
  if (!(sum > 0)) return;
  // Entries of one plant state side by side, each group summed in the order of the belief.
  std::vector<std::uint32_t> order(belief.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    go_on();
    const auto by_modes = belief[a].state.modes <=> belief[b].state.modes;
    return by_modes != 0 ? by_modes < 0 : a < b;
  });
  double best = 0;
  for (std::size_t i = 0; i < order.size();) {
    const automata::Modes& modes = belief[order[i]].state.modes;
    double group = 0;
    for (; i < order.size() && belief[order[i]].state.modes == modes; ++i) group += belief[order[i]].probability;
    if (group > best * (1 + tie_tolerance)) {
      best = group;
      estimate.modes = modes;
    }
  }
  estimate.probability = best / sum;
}

automata::Modes likeliest_initial_modes(const automata::Plant& plant) {
  automata::Modes modes;
  for (const automata::Component& component : plant.components) {
    const auto likeliest = std::max_element(component.initial.begin(), component.initial.end());
    modes.emplace_back(static_cast<std::size_t>(likeliest - component.initial.begin()));
  }
  return modes;
}

Clocks::Clocks(const automata::Plant& plant, bool live_only) : live_only_(live_only) {
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    auto& modes = live_.emplace_back();
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      modes.push_back(automata::needs_clock(plant.components[c], automata::ModeId(m)));
    }
  }
}

std::size_t SystemStateHash::operator()(const automata::SystemState& state) const noexcept {
  std::size_t hash = automata::ModesHash{}(state.modes);
  for (const automata::Ticks start : state.clock_starts) {
    hash = (hash ^ static_cast<std::size_t>(start.count)) * 0x100000001b3u;
  }
  return hash ^ (hash >> 32);
}

}  // namespace rmpl::runtime
