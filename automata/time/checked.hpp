// Sums and products of times that end with a clear word where the range of ticks ends, 292 years on.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "automata/time/time.hpp"
#include "base/error.hpp"

namespace rmpl::automata {

/// Throws the base::InputError of a time that is beyond the range; `what` names it: "cycle 12".
[[noreturn]] inline void beyond_the_end_of_time(const std::string& what) {
  throw base::InputError(what + " is beyond the end of time, " + format_seconds(Ticks::infinite() - Ticks{1}) +
                         " s (292 years); expected shorter or fewer durations");
}

/// a + b, for times that are not negative. Infinite where one of them is. Throws base::InputError past the range.
inline Ticks sum(Ticks a, Ticks b, const std::string& what) {
  if (a.is_infinite() || b.is_infinite()) return Ticks::infinite();
  Ticks result;
  if (__builtin_add_overflow(a.count, b.count, &result.count) || result.is_infinite()) beyond_the_end_of_time(what);
  return result;
}

/// time * count, neither of them negative. Throws base::InputError past the range, also for what is infinite.
inline Ticks product(Ticks time, std::int64_t count, const std::string& what) {
  Ticks result;
  if (__builtin_mul_overflow(time.count, count, &result.count) || result.is_infinite()) beyond_the_end_of_time(what);
  return result;
}

}  // namespace rmpl::automata
