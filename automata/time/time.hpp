// Time as integer ticks of one nanosecond: sums and comparisons are exact, and a run repeats to the bit.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace rmpl::automata {

/// A point in time since the start, or a length of time. Unit: 1 ns. Range: about 292 years; `infinite()` is the top.
struct Ticks {
  std::int64_t count = 0;

  static constexpr std::int64_t per_second = 1'000'000'000;
  static constexpr Ticks infinite() { return {std::numeric_limits<std::int64_t>::max()}; }
  static constexpr Ticks of_seconds(std::int64_t seconds) { return {seconds * per_second}; }

  [[nodiscard]] constexpr bool is_infinite() const { return *this == infinite(); }
  /// In seconds, for probabilities and for printing; +infinity for `infinite()`.
  [[nodiscard]] double seconds() const;

  constexpr auto operator<=>(const Ticks&) const = default;
  constexpr Ticks& operator+=(Ticks other) {
    count += other.count;
    return *this;
  }
};

constexpr Ticks operator+(Ticks a, Ticks b) { return {a.count + b.count}; }
constexpr Ticks operator-(Ticks a, Ticks b) { return {a.count - b.count}; }

/// The nearest tick to `seconds`; nothing when it is negative, not a number or beyond the range.
std::optional<Ticks> ticks_from_seconds(double seconds);

/// `30`, `30 s`, `270 min`, `0.5h`, `inf`: a number, then optionally one of ns us ms s min mins h d w weeks; a bare
/// number is seconds. Exact: the decimal is scaled, not rounded through a double. Nothing when the text is no duration,
/// is negative, has a part finer than a nanosecond, or is beyond the range.
std::optional<Ticks> parse_duration(std::string_view text);

/// In seconds, the shortest decimal that reads back the same: `43.2`, `16200`, `inf`.
std::string format_seconds(Ticks time);

}  // namespace rmpl::automata
