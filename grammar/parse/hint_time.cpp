// Hints about times: units of other languages, times as clocks show them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <system_error>

#include "base/calendar.hpp"
#include "grammar/parse/hint_words.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array<Spelling, 22> units{
    {{"nsec", "ns"},         {"nanoseconds", "ns"}, {"usec", "us"},

     {"microseconds", "us"}, {"msec", "ms"},        {"millis", "ms"}, {"milliseconds", "ms"}, {"sec", "s"},
     {"secs", "s"},          {"second", "s"},       {"seconds", "s"}, {"m", "min"},           {"minute", "min"},
     {"minutes", "min"},     {"hr", "h"},           {"hour", "h"},    {"hours", "h"},         {"day", "d"},
     {"days", "d"},          {"wk", "w"},           {"week", "w"}}};

/// Numbers with units one behind the other, as in `5min30s`, in seconds; nothing where they are none, or not whole.
std::optional<std::uint64_t> seconds_in(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::uint64_t>, 6> sizes{
      {{"s", 1}, {"min", 60}, {"mins", 60}, {"h", 3600}, {"d", 86400}, {"w", 604800}}};
  std::uint64_t sum = 0;
  while (!text.empty()) {
    std::uint64_t number = 0;
    const auto [behind, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || number > 1'000'000) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(behind - text.data()));
    const std::string_view unit = text.substr(0, std::min(text.find_first_of("0123456789"), text.size()));
    const auto* size = std::find_if(sizes.begin(), sizes.end(), [&](const auto& known) { return known.first == unit; });
    if (size == sizes.end()) return std::nullopt;
    sum += number * size->second;
    text.remove_prefix(unit.size());
  }
  return sum;
}

}  // namespace

std::optional<Hint> time_hint(const Unexpected& place) {
  const std::string_view number = last_word(place.before);
  if (place.expected == "`/`" && !number.empty()) {
    const std::string rate(number);
    return say("a rate is per unit of time, `with rate " + rate + " /h`; a probability is `with " + rate + "`");
  }
  if (number.empty() || std::isdigit(static_cast<unsigned char>(number.front())) == 0) return std::nullopt;
  if (place.before.ends_with(number) && place.found.find_first_of("0123456789") != std::string_view::npos) {
    const std::string_view whole = joined(number, place.found);
    if (const auto seconds = seconds_in(whole)) {
      const std::string text = std::to_string(*seconds) + " s";
      return Hint{"a duration has one unit: `" + text + "`", whole, text};
    }
  }
  if (place.found != ":" || place.behind.empty() || std::isdigit(static_cast<unsigned char>(place.behind[0])) == 0) {
    return std::nullopt;
  }
  const std::string_view rest = place.behind.substr(0, place.behind.find_first_not_of("0123456789:"));
  const std::size_t colon = rest.find(':');
  if (colon != std::string_view::npos) {
    const auto seconds = seconds_in(std::string(number) + "h" + std::string(rest.substr(0, colon)) + "min" +
                                    std::string(rest.substr(colon + 1)) + "s");
    if (seconds) {
      const std::string text = std::to_string(*seconds) + " s";
      return Hint{"a time is a number and a unit: `" + text + "`", joined(number, rest), text};
    }
  }
  return say("a time is a number and a unit, as in `5 min`");
}

std::optional<Hint> unit_hint(const Unexpected& place) {
  const std::string_view number = last_word(place.before);
  const bool measured = !number.empty() && std::isdigit(static_cast<unsigned char>(number.front())) != 0;
  if (!measured && !place.expected.starts_with("a unit")) return std::nullopt;
  if (const auto reason = base::calendar_reason(place.found)) return say(*reason);
  if ((place.found == "µ" || place.found == "μ") && place.behind.starts_with("s")) {
    return did_you_mean("us", joined(place.found, place.behind.substr(0, 1)));
  }
  for (const auto& [found, meant] : units) {
    if (found != place.found) continue;
    Hint unit = did_you_mean(meant, place.found);
    unit.suggestion += " Units of time are ns, us, ms, s, min, h, d and w";
    return unit;
  }
  return std::nullopt;
}

}  // namespace rmpl::grammar
