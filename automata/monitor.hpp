// Monitors: how the numbers and words of a telemetry channel become readings of an attribute.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "automata/logic/ids.hpp"
#include "automata/origin.hpp"
#include "automata/time/time.hpp"

namespace rmpl::automata {

/// Numbers that mean a value: `low below 280;` has no `from`, and its `to` does not belong to it.
struct Band {
  ValueId value;
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  bool open_from = false;  ///< `from` itself does not belong to it
  bool open_to = false;    ///< nor `to`
  Origin origin;
  bool operator==(const Band&) const = default;

  /// Whether the number lies within the limits, moved outwards by `margin`, in the unit of the channel, at least 0.
  [[nodiscard]] bool contains(double number, double margin = 0) const {
    const double low = from - margin;
    const double high = to + margin;
    return (open_from ? number > low : number >= low) && (open_to ? number < high : number <= high);
  }
};

/// What a channel says for a value: a text, or a number, to the last bit.
struct ChannelLiteral {
  ValueId value;
  std::string text;
  std::optional<double> number;
  bool operator==(const ChannelLiteral&) const = default;
};

/// A block of a monitor file (semantics, "Monitors").
struct Monitor {
  std::string channel;
  std::optional<std::string> minus;      ///< the signal is the difference of two channels
  std::optional<Ticks> over;             ///< the signal is the rate of the channel a second, over this time
  VariableId attribute;                  ///< observed
  std::vector<Band> bands;               ///< in the order of the file; where two share a limit, it is the first's
  std::vector<ChannelLiteral> literals;  ///< of a plain channel only
  double hysteresis = 0;                 ///< a value is left only where its limit is passed by so much
  std::uint64_t persist_samples = 1;     ///< and by so many samples in a row,
  Ticks persist_time;                    ///< and for so long
  std::optional<Ticks> stale;            ///< after so long without a sample there is no reading; none: never
  Origin origin;
  std::size_t plant = 0;  ///< that the attribute is of: its position in the document
  bool operator==(const Monitor&) const = default;
};

}  // namespace rmpl::automata
