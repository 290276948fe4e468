// The times of a log: where they count from, in which unit, and which samples are odd.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "automata/time/time.hpp"
#include "base/function_ref.hpp"
#include "runtime/telemetry/time_text.hpp"

namespace rmpl::runtime {

struct LogTimeOptions {
  bool from_first = false;         ///< the first time of the log is time 0
  std::optional<TimeText> origin;  ///< this time is time 0
  std::optional<std::int64_t> unit =
      {};  ///< of numbers, in nanoseconds; else seconds, or what Unix time is in by its size
};

/// What becomes of a time that follows others in a log.
enum class TimeFate {
  follows,        ///< it is no earlier than the time before
  out_of_order,   ///< it is
  wrong_unit,     ///< in another unit it would follow: a sample in milliseconds among samples in seconds
  before_origin,  ///< it lies before time 0
  repeated        ///< set by the reader: the sample stands there twice
};

/// Turns the texts of times into ticks since time 0, in the order in which they stand in the log.
///
/// A number is in seconds. From 10^11 on it would lie beyond the year 5138, and is Unix time in milliseconds; from
/// 10^14 on in microseconds, from 10^17 on in nanoseconds. Dates count from the first of them where no origin is named.
/// A sample is in a *wrong unit* where its number is of another such size than the first one. It is so, too, where all
/// of these hold, a step being the longest so far: it lies more than 100 steps from the time before; its number times
/// or by 10^3, 10^6 or 10^9 comes within two steps after that time; the sample after it lies before it.
class LogTimes {
 public:
  struct Place {
    automata::Ticks time;
    TimeFate fate = TimeFate::follows;
  };

  explicit LogTimes(LogTimeOptions options = {}) : options_(options) {}

  /// The time of the next sample; nothing at the end. Asked only where one sample does not tell.
  using Peek = base::FunctionRef<std::optional<TimeText>()>;

  /// Nothing where the time is beyond what ticks hold. A time that does not follow leaves no mark.
  std::optional<Place> place(const TimeText& text, const Peek& peek);
  /// Counts a sample that is left out for this reason.
  void leave_out(TimeFate fate, std::size_t line);

  /// What is to be told of the times read since this was asked last: a first step of more than a day though no origin
  /// is named, dates that were counted from the first, a unit that was recognised.
  std::vector<std::string> take_remarks();
  /// A line for each kind of sample that was left out: how many, and where the first stands.
  [[nodiscard]] std::vector<std::string> left_out() const;

 private:
  struct Count {
    std::size_t samples = 0;
    std::size_t first_line = 0;
  };

  [[nodiscard]] WideNanoseconds since_origin_of(const TimeText& text) const;
  [[nodiscard]] bool may_be_in_another_unit(WideNanoseconds time) const;
  void begin(const TimeText& text);

  LogTimeOptions options_;
  bool begun_ = false;
  bool placed_ = false;    ///< a time that follows was seen
  std::int64_t unit_ = 0;  ///< of numbers
  WideNanoseconds origin_ = 0;
  WideNanoseconds last_ = 0;
  WideNanoseconds longest_ = 0;  ///< step between two samples
  std::vector<std::string> remarks_;
  std::array<Count, 5> counts_{};
};

}  // namespace rmpl::runtime
