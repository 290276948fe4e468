// Time as integer ticks: reading and writing durations without loss.
// SPDX-License-Identifier: MIT
#include "automata/time/time.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace rmpl::automata {
namespace {

__extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): __extension__ wants a typedef

constexpr std::array<std::pair<std::string_view, std::int64_t>, 11> units{{{"ns", 1},
                                                                           {"us", 1'000},
                                                                           {"ms", 1'000'000},
                                                                           {"s", 1'000'000'000},
                                                                           {"min", 60'000'000'000},
                                                                           {"mins", 60'000'000'000},
                                                                           {"h", 3'600'000'000'000},
                                                                           {"d", 86'400'000'000'000},
                                                                           {"w", 604'800'000'000'000},
                                                                           {"weeks", 604'800'000'000'000},
                                                                           {"", 1'000'000'000}}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\n\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\n\r") - first + 1);
}

/// digits * 10^exponent * unit, exactly; nothing where it is no whole number of ticks or out of range.
std::optional<Ticks> scaled(std::string_view digits, long exponent, std::int64_t unit) {
  constexpr Wide limit = std::numeric_limits<std::int64_t>::max();
  const auto significant = digits.find_first_not_of('0');
  if (significant == std::string_view::npos) return Ticks{0};
  digits.remove_prefix(significant);
  while (digits.back() == '0') {
    digits.remove_suffix(1);
    ++exponent;
  }
  // No tick needs more digits: 22, of days with sixteen decimals.
  if (digits.size() > 24) return std::nullopt;
  Wide value = 0;
  for (const char c : digits) value = value * 10 + (c - '0');
  value *= unit;
  if (exponent > 20 || exponent < -40) return std::nullopt;
  for (; exponent > 0; --exponent) {
    if (value >= limit) return std::nullopt;
    value *= 10;
  }
  for (; exponent < 0; ++exponent) {
    if (value % 10 != 0) return std::nullopt;
    value /= 10;
  }
  if (value >= limit) return std::nullopt;
  return Ticks{static_cast<std::int64_t>(value)};
}

}  // namespace

double Ticks::seconds() const {
  if (is_infinite()) return std::numeric_limits<double>::infinity();
  return static_cast<double>(count) / static_cast<double>(per_second);
}

std::optional<Ticks> ticks_from_seconds(double seconds) {
  if (!(seconds >= 0) || seconds > 9.2e9) return std::nullopt;
  return Ticks{std::llround(seconds * static_cast<double>(Ticks::per_second))};
}

std::optional<Ticks> parse_duration(std::string_view text) {
  text = trimmed(text);
  if (text == "inf" || text == "∞") return Ticks::infinite();
  std::string digits;
  long exponent = 0;
  std::size_t at = 0;
  for (; at < text.size() && is_digit(text[at]); ++at) digits += text[at];
  if (digits.empty()) return std::nullopt;
  if (at + 1 < text.size() && text[at] == '.' && is_digit(text[at + 1])) {
    for (++at; at < text.size() && is_digit(text[at]); ++at, --exponent) digits += text[at];
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t after = at + 1;
    if (after + 1 < text.size() && text[after] == '+' && is_digit(text[after + 1])) ++after;
    long power = 0;
    const auto [end, error] = std::from_chars(text.data() + after, text.data() + text.size(), power);
    if (error != std::errc{} || power > 1000 || power < -1000) return std::nullopt;
    at = static_cast<std::size_t>(end - text.data());
    exponent += power;
  }
  const std::string_view unit = trimmed(text.substr(at));
  const auto* known = std::find_if(units.begin(), units.end(), [&](const auto& u) { return u.first == unit; });
  if (known == units.end()) return std::nullopt;
  return scaled(digits, exponent, known->second);
}

std::string format_seconds(Ticks time) {
  if (time.is_infinite()) return "inf";
  const bool negative = time.count < 0;
  const auto magnitude = negative ? 0 - static_cast<std::uint64_t>(time.count) : static_cast<std::uint64_t>(time.count);
  const auto unit = static_cast<std::uint64_t>(Ticks::per_second);
  std::string text = (negative ? "-" : "") + std::to_string(magnitude / unit);
  if (const auto part = magnitude % unit; part != 0) {
    std::string decimals = std::to_string(part);
    decimals.insert(0, 9 - decimals.size(), '0');
    decimals.erase(decimals.find_last_not_of('0') + 1);
    text += "." + decimals;
  }
  return text;
}

}  // namespace rmpl::automata
