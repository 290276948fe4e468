// Moments of a flight as people read them: in seconds, and from a minute on as hours, minutes and seconds.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/time/time.hpp"

namespace rmpl::runtime {

/// `4:30:44.5`, exact to the last digit; not for infinity.
std::string hours_minutes_seconds(automata::Ticks time);

/// A moment in a sentence: `43.5 s`, `16244.5 s (4:30:44.5)`.
std::string moment(automata::Ticks time);

/// The moments of one flight, all of one width, so that what stands behind them is aligned.
class MomentColumn {
 public:
  /// For times up to `end` in steps of `cycle`; longer ones are wider.
  MomentColumn(automata::Ticks end, automata::Ticks cycle);
  [[nodiscard]] std::string text(automata::Ticks time) const;

 private:
  std::size_t seconds_width_;
  std::size_t clock_width_ = 0;  ///< 0 where no time lasts beyond a minute
};

}  // namespace rmpl::runtime
