// Reads times: a decimal is scaled and rounded once, never held as a double.
// SPDX-License-Identifier: MIT
#include "runtime/telemetry/time_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>

namespace rmpl::runtime {
namespace {

using Kind = TimeText::Kind;

constexpr WideNanoseconds per_second = automata::Ticks::per_second;
constexpr int most_digits = 28;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// Takes a text apart from its left end.
class Taker {
 public:
  explicit Taker(std::string_view text) : rest_(text) {}

  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  bool take(std::string_view word) {
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  /// Digits, `least` to `most` of them.
  std::optional<long> digits(std::size_t least, std::size_t most) {
    std::size_t n = 0;
    while (n < rest_.size() && is_digit(rest_[n])) ++n;
    if (n < least || n > most) return std::nullopt;
    long value = 0;
    std::from_chars(rest_.data(), rest_.data() + n, value);
    rest_.remove_prefix(n);
    return value;
  }
  void blanks() {
    while (take(' ')) {
    }
  }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] bool done() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

/// The value of a decimal times 10^9, rounded; the decimal is taken off `rest`.
std::optional<WideNanoseconds> take_decimal(std::string_view& rest) {
  std::size_t at = 0;
  const bool negative = !rest.empty() && rest.front() == '-';
  if (negative || (!rest.empty() && rest.front() == '+')) ++at;
  std::array<char, most_digits + 1> digits{};
  std::size_t kept = 0;
  bool any = false, in_fraction = false;
  long exponent = 9;
  for (; at < rest.size(); ++at) {
    const char c = rest[at];
    if (c == '.' && !in_fraction && at + 1 < rest.size() && is_digit(rest[at + 1])) {
      in_fraction = true;
      continue;
    }
    if (!is_digit(c)) break;
    any = true;
    if (in_fraction) --exponent;
    if (kept == 0 && c == '0') continue;
    if (kept < digits.size()) {
      digits[kept++] = c;
    } else {
      ++exponent;  // too far behind the first digit to count
    }
  }
  if (!any) return std::nullopt;
  if (at < rest.size() && (rest[at] == 'e' || rest[at] == 'E')) {
    std::size_t after = at + 1;
    if (after + 1 < rest.size() && rest[after] == '+' && is_digit(rest[after + 1])) ++after;
    long power = 0;
    const auto [end, error] = std::from_chars(rest.data() + after, rest.data() + rest.size(), power);
    if (error != std::errc{} || power > 1000 || power < -1000) return std::nullopt;
    at = static_cast<std::size_t>(end - rest.data());
    exponent += power;
  }
  rest.remove_prefix(at);
  WideNanoseconds value = 0;
  if (exponent >= 0) {
    if (kept != 0 && static_cast<long>(kept) + exponent > most_digits) return std::nullopt;
    for (std::size_t i = 0; i < kept; ++i) value = value * 10 + (digits[i] - '0');
    for (; kept != 0 && exponent > 0; --exponent) value *= 10;
  } else {
    const long whole = static_cast<long>(kept) + exponent;  // digits that are left
    if (whole > most_digits) return std::nullopt;
    for (long i = 0; i < whole; ++i) value = value * 10 + (digits[static_cast<std::size_t>(i)] - '0');
    if (whole >= 0 && digits[static_cast<std::size_t>(whole)] >= '5') ++value;
  }
  return negative ? -value : value;
}

std::optional<TimeText> read_number(std::string_view text) {
  const auto count = take_decimal(text);
  if (!count) return std::nullopt;
  text = trimmed(text);
  if (text.empty()) return TimeText{Kind::number, *count};
  const auto unit = automata::parse_duration("1" + std::string(text));
  if (!unit || unit->is_infinite() || is_digit(text.front()) || text.front() == '.') return std::nullopt;
  WideNanoseconds scaled = 0;
  if (__builtin_mul_overflow(*count, WideNanoseconds{unit->count}, &scaled)) return std::nullopt;
  const WideNanoseconds half = scaled < 0 ? -per_second / 2 : per_second / 2;
  return TimeText{Kind::duration, (scaled + half) / per_second};
}

/// `SS[.f]`, at most 60: a leap second is the second after.
std::optional<WideNanoseconds> seconds_of(Taker& taker) {
  std::string_view rest = taker.rest();
  if (rest.size() < 2 || !is_digit(rest[0]) || !is_digit(rest[1]) || (rest.size() > 2 && is_digit(rest[2]))) {
    return std::nullopt;
  }
  std::string decimal(rest.substr(0, 2));
  taker.digits(2, 2);
  if (taker.take('.') || taker.take(',')) {
    decimal += '.';
    while (!taker.rest().empty() && is_digit(taker.rest().front())) {
      decimal += taker.rest().front();
      taker.take(taker.rest().front());
    }
    if (decimal.back() == '.') return std::nullopt;
  }
  std::string_view text = decimal;
  const auto value = take_decimal(text);
  if (!value || *value >= 61 * per_second) return std::nullopt;
  return value;
}

std::optional<TimeText> read_mission(std::string_view text) {
  Taker taker(text);
  if (!taker.take("MET")) taker.take('T');
  taker.blanks();
  const bool negative = taker.take('-');
  if (!negative) taker.take('+');
  long days = 0;
  auto hours = taker.digits(1, 6);
  if (!hours) return std::nullopt;
  if (taker.take('/')) {
    days = *hours;
    hours = taker.digits(1, 2);
  }
  if (!hours || !taker.take(':')) return std::nullopt;
  auto minutes = taker.digits(1, 2);
  if (!minutes) return std::nullopt;
  WideNanoseconds seconds = 0;
  if (taker.take(':')) {
    // `a:b:c:d` begins with days.
    Taker ahead = taker;
    const auto third = ahead.digits(1, 2);
    if (third && ahead.take(':')) {
      days = days * 24 + *hours;
      hours = minutes;
      minutes = third;
      taker = ahead;
    }
    const auto read = seconds_of(taker);
    if (!read) return std::nullopt;
    seconds = *read;
  }
  if (!taker.done() || *minutes > 59) return std::nullopt;
  const WideNanoseconds count =
      ((static_cast<WideNanoseconds>(days) * 24 + *hours) * 60 + *minutes) * 60 * per_second + seconds;
  return TimeText{Kind::mission, negative ? -count : count};
}

std::optional<WideNanoseconds> day_of(Taker& taker) {
  using namespace std::chrono;
  const auto year_read = taker.digits(4, 4);
  if (!year_read || !taker.take('-')) return std::nullopt;
  const year in(static_cast<int>(*year_read));
  Taker ahead = taker;
  if (const auto ordinal = ahead.digits(3, 3)) {
    if (*ordinal < 1 || *ordinal > (in.is_leap() ? 366 : 365)) return std::nullopt;
    taker = ahead;
    return WideNanoseconds{(sys_days(in / January / 1) + days(*ordinal - 1)).time_since_epoch().count()};
  }
  const auto month_read = taker.digits(2, 2);
  if (!month_read || !taker.take('-')) return std::nullopt;
  const auto day_read = taker.digits(2, 2);
  if (!day_read) return std::nullopt;
  const year_month_day date = in / static_cast<int>(*month_read) / static_cast<int>(*day_read);
  if (!date.ok()) return std::nullopt;
  return WideNanoseconds{sys_days(date).time_since_epoch().count()};
}

/// Nanoseconds east of Greenwich.
std::optional<WideNanoseconds> zone_of(Taker& taker) {
  if (taker.done() || taker.take('Z') || taker.take('z')) return WideNanoseconds{0};
  const bool west = taker.take('-');
  if (!west && !taker.take('+')) return std::nullopt;
  Taker compact = taker;
  if (const auto both = compact.digits(4, 4)) {
    taker = compact;
    if (*both % 100 > 59 || *both > 2359) return std::nullopt;
    const WideNanoseconds east = (*both / 100 * 60 + *both % 100) * 60 * per_second;
    return west ? -east : east;
  }
  const auto hours = taker.digits(2, 2);
  if (!hours || *hours > 23) return std::nullopt;
  const auto minutes = taker.take(':') ? taker.digits(2, 2) : std::optional(0L);
  if (!minutes || *minutes > 59) return std::nullopt;
  const WideNanoseconds east = (*hours * 60 + *minutes) * 60 * per_second;
  return west ? -east : east;
}

std::optional<TimeText> read_date(std::string_view text) {
  Taker taker(text);
  const auto day = day_of(taker);
  if (!day) return std::nullopt;
  WideNanoseconds count = *day * 86'400 * per_second;
  if (taker.done()) return TimeText{Kind::date, count};
  if (!taker.take('T') && !taker.take('t') && !taker.take(' ')) return std::nullopt;
  const auto hours = taker.digits(2, 2);
  if (!hours || *hours > 24 || !taker.take(':')) return std::nullopt;
  const auto minutes = taker.digits(2, 2);
  if (!minutes || *minutes > 59) return std::nullopt;
  count += (*hours * 60 + *minutes) * 60 * per_second;
  if (taker.take(':')) {
    const auto seconds = seconds_of(taker);
    if (!seconds) return std::nullopt;
    count += *seconds;
  }
  taker.blanks();
  const auto zone = zone_of(taker);
  if (!zone || !taker.done()) return std::nullopt;
  return TimeText{Kind::date, count - *zone};
}

}  // namespace

std::optional<TimeText> read_time_text(std::string_view text) {
  text = trimmed(text);
  if (text.empty() || text.size() > 64) return std::nullopt;
  const bool year = text.size() > 5 && text[4] == '-' && std::all_of(text.begin(), text.begin() + 4, is_digit);
  if (year) return read_date(text);
  return text.find(':') == std::string_view::npos ? read_number(text) : read_mission(text);
}

std::string format_date(WideNanoseconds since_1970) {
  using namespace std::chrono;
  const auto whole = static_cast<std::int64_t>(since_1970 / per_second);
  const auto day = floor<days>(sys_seconds(seconds(whole)));
  const year_month_day date(day);
  const hh_mm_ss time(sys_seconds(seconds(whole)) - day);
  std::array<char, 80> text{};
  const int size = std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02dZ",
                                 static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                                 static_cast<unsigned>(date.day()), static_cast<int>(time.hours().count()),
                                 static_cast<int>(time.minutes().count()), static_cast<int>(time.seconds().count()));
  return {text.data(), static_cast<std::size_t>(size)};
}

}  // namespace rmpl::runtime
