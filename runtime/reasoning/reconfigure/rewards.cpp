// Decimals as whole numbers: the shortest decimal that reads back as the same number is the one that was written.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/rewards.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace rmpl::runtime {

namespace {

/// The power of ten of the last digit that is written.
int last_digit(double value) {
  if (value == 0) return 0;
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.begin(), text.end(), value, std::chars_format::scientific).ptr;
  const auto* const e = std::find(text.begin(), end, 'e');
  const auto* const point = std::find(static_cast<const char*>(text.begin()), e, '.');
  const int decimals = point == e ? 0 : static_cast<int>(e - point) - 1;
  return std::atoi(e + 1) - decimals;
}

}  // namespace

WholeRewards whole_rewards(const automata::Plant& plant) {
  int finest = 0;
  double spread = 1;
  double count = 1;
  for (const automata::Component& component : plant.components) {
    double least = 0;
    double greatest = 0;
    for (const automata::Mode& mode : component.modes) {
      finest = std::min(finest, last_digit(mode.reward));
      least = std::min(least, mode.reward);
      greatest = std::max(greatest, mode.reward);
    }
    spread += greatest - least;
    count += 1;
  }
  const double room = std::ldexp(1.0, 53) / (count * count);
  while (spread * std::pow(10.0, -finest) > room) ++finest;
  WholeRewards whole;
  for (const automata::Component& component : plant.components) {
    auto& units = whole.emplace_back();
    for (const automata::Mode& mode : component.modes) {
      units.push_back(std::llround(mode.reward * std::pow(10.0, -finest)));
    }
  }
  return whole;
}

}  // namespace rmpl::runtime
