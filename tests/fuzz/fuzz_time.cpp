// Fuzzes durations: each text is read as the decimal that it is, digit by digit, and what is read is written and read
// again.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "automata/time/time.hpp"
#include "base/check.hpp"

using rmpl::automata::Ticks;

namespace {

/// A whole number, its least digit first.
using Number = std::vector<int>;

Number product(const Number& number, std::int64_t factor) {
  Number result;
  std::int64_t carry = 0;
  for (std::size_t at = 0; at < number.size() || carry != 0; ++at) {
    const std::int64_t sum = carry + (at < number.size() ? number[at] * factor : 0);
    result.push_back(static_cast<int>(sum % 10));
    carry = sum / 10;
  }
  return result;
}

/// Nothing beyond the range of ticks, whose end stands for `inf`.
std::optional<Ticks> ticks_of(const Number& number) {
  std::int64_t count = 0;
  for (std::size_t at = number.size(); at-- > 0;) {
    if (__builtin_mul_overflow(count, 10, &count) || __builtin_add_overflow(count, number[at], &count))
      return std::nullopt;
  }
  if (Ticks{count}.is_infinite()) return std::nullopt;
  return Ticks{count};
}

std::int64_t nanoseconds(std::string_view unit) {
  static const std::vector<std::pair<std::string_view, std::int64_t>> units = {{"ns", 1},
                                                                               {"w", 604'800'000'000'000},
                                                                               {"weeks", 604'800'000'000'000},
                                                                               {"us", 1'000},
                                                                               {"ms", 1'000'000},
                                                                               {"s", 1'000'000'000},
                                                                               {"", 1'000'000'000},
                                                                               {"min", 60'000'000'000},
                                                                               {"mins", 60'000'000'000},
                                                                               {"h", 3'600'000'000'000},
                                                                               {"d", 86'400'000'000'000}};
  return std::find_if(units.begin(), units.end(), [&](const auto& known) { return known.first == unit; })->second;
}

/// The duration that the text says, by its definition.
std::optional<Ticks> read(const std::string& text) {
  static const std::regex form(
      R"([ \t\n\r]*(?:(inf|∞)|([0-9]+)(?:\.([0-9]+))?(?:[eE]([+-]?[0-9]+))?[ \t\n\r]*(ns|us|ms|s|mins?|h|d|w|weeks|))[ \t\n\r]*)");
  std::smatch found;
  if (!std::regex_match(text, found, form)) return std::nullopt;
  if (found[1].matched) return Ticks::infinite();
  const std::string fraction = found[3];
  const std::string digits = found[2].str() + fraction;
  Number number(digits.rbegin(), digits.rend());
  for (int& digit : number) digit -= '0';
  number = product(number, nanoseconds(found[5].str()));
  // What is scaled by more is refused, whatever it is.
  const std::string power = found[4];
  const std::size_t significant = std::min(power.find_first_not_of("+-0"), power.size());
  if (power.size() - significant > 4 || (significant < power.size() && std::labs(std::stol(power)) > 1000))
    return std::nullopt;
  long shift = (power.empty() ? 0 : std::stol(power)) - static_cast<long>(fraction.size());
  for (; shift > 0; --shift) number.insert(number.begin(), 0);
  for (; shift < 0 && !number.empty(); ++shift) {
    if (number.front() != 0) return std::nullopt;
    number.erase(number.begin());
  }
  return ticks_of(number);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t longest = 64;
  if (size > longest) return 0;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::optional<Ticks> ticks = rmpl::automata::parse_duration(text);
  CHECK(ticks == read(text));
  if (ticks) CHECK(rmpl::automata::parse_duration(rmpl::automata::format_seconds(*ticks)) == ticks);
  return 0;
}
