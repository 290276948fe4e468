// What a channel of telemetry says at one time.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rmpl::runtime {

/// A sample as it is written. A text that reads as a number is one: a CSV file does not tell them apart.
struct Sample {
  std::uint32_t channel = 0;     ///< position among the channels of `Monitors`
  std::optional<double> number;  ///< perhaps infinite or not a number; none: a text
  std::string text;              ///< as written, without blanks around it

  static Sample of_text(std::uint32_t channel, std::string_view text);
  static Sample of_number(std::uint32_t channel, double number, std::string text) {
    return {channel, number, std::move(text)};
  }
  bool operator==(const Sample&) const = default;

  /// A finite number as the shortest decimal that reads back the same, all else as it is written, between quotes.
  [[nodiscard]] std::string told() const;
};

}  // namespace rmpl::runtime
