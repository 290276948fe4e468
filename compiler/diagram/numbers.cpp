// Shortest decimals; bounds, densities, weights.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/numbers.hpp"

#include <array>
#include <charconv>
#include <utility>

namespace rmpl::compiler {
namespace {

using automata::Density;

constexpr std::size_t digits_of_double = 32;
constexpr int digits_of_rate = 15;  // what survives the division by the seconds of a unit

/// `1e-06` as `1e-6`.
std::string with_short_exponent(std::string text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::size_t digit = e + 1;
  if (text[digit] == '+') text.erase(digit, 1);
  if (text[digit] == '-') ++digit;
  while (text[digit] == '0' && digit + 1 < text.size()) text.erase(digit, 1);
  return text;
}

std::string rate(double per_second) {
  constexpr std::array<std::pair<double, const char*>, 4> units{
      {{3600, " /h"}, {1, " /s"}, {60, " /min"}, {86400, " /d"}}};
  std::string best;
  std::size_t least = digits_of_double;
  for (const auto& [seconds, unit] : units) {
    std::array<char, digits_of_double> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), per_second * seconds,
                                   std::chars_format::general, digits_of_rate)
                         .ptr;
    const std::string number = with_short_exponent({buffer.data(), end});
    if (number.size() >= least) continue;
    least = number.size();
    best = number + unit;
  }
  return best;
}

}  // namespace

std::string shortest(double value) {
  std::array<char, digits_of_double> buffer{};
  return with_short_exponent({buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr});
}

std::string to_text(const automata::Timing& timing) {
  const auto duration = [](automata::Ticks time) {
    return time.is_infinite() ? std::string("inf") : automata::format_seconds(time) + " s";
  };
  std::string text = timing.lower == timing.upper
                         ? "after " + duration(timing.lower)
                         : "in [" + duration(timing.lower) + ", " + duration(timing.upper) + "]";
  switch (timing.density.kind) {
    case Density::Kind::uniform:
      break;
    case Density::Kind::exponential:
      text += " ~ exponential(" + shortest(timing.density.mean) + " s)";
      break;
    case Density::Kind::normal:
      text +=
          " ~ normal(" + shortest(timing.density.mean) + " s, " + shortest(timing.density.standard_deviation) + " s)";
      break;
    case Density::Kind::weibull:
      text += " ~ weibull(" + shortest(timing.density.shape) + ", " + shortest(timing.density.scale) + " s)";
      break;
    case Density::Kind::erlang:
      text += " ~ erlang(" + shortest(timing.density.shape) + ", " + shortest(timing.density.mean) + " s)";
      break;
  }
  return text;
}

std::string to_text(const automata::Weight& weight) {
  switch (weight.kind) {
    case automata::Weight::Kind::none:
      return {};
    case automata::Weight::Kind::probability:
      return "with " + shortest(weight.value);
    case automata::Weight::Kind::rate:
      return "with rate " + rate(weight.value);
  }
  return {};
}

}  // namespace rmpl::compiler
