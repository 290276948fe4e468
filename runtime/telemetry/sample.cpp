// Texts of samples.
// SPDX-License-Identifier: MIT
#include "runtime/telemetry/sample.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace rmpl::runtime {

Sample Sample::of_text(std::uint32_t channel, std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  text = first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(blanks) - first + 1);
  Sample sample{channel, std::nullopt, std::string(text)};
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error == std::errc{} && !digits.empty() && end == digits.data() + digits.size()) sample.number = number;
  return sample;
}

std::string Sample::told() const {
  if (!number || !std::isfinite(*number)) return '"' + text + '"';
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), *number).ptr;
  return {digits.data(), end};
}

}  // namespace rmpl::runtime
