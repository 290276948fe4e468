// Sums and products of times that end where time ends, instead of wrapping around.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "automata/time/time.hpp"

namespace rmpl::automata {

/// a + b, for both from 0; nothing where that is not before `Ticks::infinite()`.
constexpr std::optional<Ticks> checked_sum(Ticks a, Ticks b) {
  if (b.count >= Ticks::infinite().count - a.count) return std::nullopt;
  return a + b;
}

/// a * times, for `a` from 0; nothing where that is not before `Ticks::infinite()`.
constexpr std::optional<Ticks> checked_product(Ticks a, std::uint64_t times) {
  if (a.count == 0) return a;
  if (times > static_cast<std::uint64_t>((Ticks::infinite().count - 1) / a.count)) return std::nullopt;
  return Ticks{a.count * static_cast<std::int64_t>(times)};
}

}  // namespace rmpl::automata
