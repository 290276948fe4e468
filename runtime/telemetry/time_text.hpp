// A time as a log writes it: seconds, a duration with a unit, a date, or the clock of a mission.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "automata/time/time.hpp"

namespace rmpl::runtime {

/// Nanoseconds that need not fit into ticks: Unix time in nanoseconds, read as seconds, does not.
__extension__ typedef __int128 WideNanoseconds;  // NOLINT(modernize-use-using): __extension__ wants a typedef

/// What the text of a time says. Rounded to the nearest nanosecond, halves away from 0: a program that adds 0.1 s to
/// 0.2 s writes 0.30000000000000004, and means 0.3 s.
struct TimeText {
  enum class Kind {
    number,    ///< of an unnamed unit; `count` takes it for seconds
    duration,  ///< with a unit
    mission,   ///< hours, minutes and seconds since the start of the mission
    date       ///< of the calendar; `count` is since 1970-01-01T00:00:00Z, without leap seconds, as Unix time is
  };
  Kind kind = Kind::number;
  WideNanoseconds count = 0;
  bool operator==(const TimeText&) const = default;
};

/// Reads a text. Nothing where it is no time, or above 10^28 ns in size.
///
/// | kind | texts |
/// |---|---|
/// | number | `12`, `-0.5`, `1.7e9` |
/// | duration | a number and a unit of `automata::parse_duration`: `270 min` |
/// | mission | `[T][+|-][days/]hours:minutes[:seconds]` and `days:hours:minutes:seconds`, `T+4:34:45.5`; also `MET` for
/// T | | date | ISO 8601: `2023-11-14`, by the day of the year `2023-318`; then `T` or a blank and `22:13[:20[.5]]`;
/// then `Z`, `+02:00`, `+0200` or `+02`; without a zone it is UTC |
std::optional<TimeText> read_time_text(std::string_view text);

/// `2023-11-14T22:13:20Z`, for messages.
std::string format_date(WideNanoseconds since_1970);

}  // namespace rmpl::runtime
