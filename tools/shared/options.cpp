// Reading the texts of options.
// SPDX-License-Identifier: MIT
#include "tools/shared/options.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "base/calendar.hpp"

namespace rmpl::tools {

using automata::Ticks;

void add_common(Command& command, Common& common) {
  add_choice<Color>(command, "--color", common.color,
                    {{"auto", Color::automatic}, {"always", Color::always}, {"never", Color::never}},
                    "colours; auto, the default: on a terminal, unless NO_COLOR is set");
  add_read(command, "--max-input", common.max_input, memory_size,
           "the limit for the size of a file or of a line of a log (default: 1G)")
      .option_text("BYTES[K|M|G]");
  command.add_flag("-q,--quiet", common.quiet, "print less: no warnings, no progress, no story");
  command.add_flag("-v,--verbose", common.verbose, "print more: the inputs and the cost");
}

void add_format(Command& command, Common& common, bool junit) {
  std::vector<std::pair<std::string, Format>> forms{{"text", Format::text}, {"json", Format::json}};
  if (junit) forms.emplace_back("junit", Format::junit);
  add_choice<Format>(command, "--format", common.format, forms,
                     junit ? "text for people (the default), json for programs, junit for continuous integration"
                           : "text for people (the default), json for programs");
}

std::optional<double> real_number(const std::string& text) {
  try {
    std::size_t end = 0;
    const double value = std::stod(text, &end);
    if (end == text.size()) return value;
  } catch (const std::exception&) {
    // It begins with none, or with one that is too large.
  }
  return std::nullopt;
}

std::uint64_t whole_number(const std::string& text, std::uint64_t least, std::uint64_t most) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, number);
  if (parsed.ec == std::errc{} && parsed.ptr == end && number >= least && number <= most) return number;
  const bool any = most == std::numeric_limits<std::uint64_t>::max();
  throw BadValue("expected a whole number from " + std::to_string(least) + " to " +
                 (any ? std::string("2^64 - 1") : std::to_string(most)) + ", not '" + text + "'");
}

Ticks duration(const std::string& text) {
  if (const auto ticks = automata::parse_duration(text)) return *ticks;
  const std::size_t unit = text.find_last_not_of("abcdefghijklmnopqrstuvwxyz") + 1;
  if (const auto reason = base::calendar_reason(std::string_view(text).substr(unit))) {
    throw BadValue("'" + text + "' is no duration: " + *reason);
  }
  throw BadValue("'" + text +
                 "' is no duration; expected a number and perhaps a unit (ns, us, ms, s, min, h, d or w), as in 30, "
                 "5ms or 4.5h, of less than 292 years");
}

Ticks positive_duration(const std::string& text) {
  const Ticks ticks = duration(text);
  if (ticks > Ticks{0} && !ticks.is_infinite()) return ticks;
  throw BadValue("'" + text + "' is no length of time; expected a finite duration above 0");
}

std::size_t memory_size(const std::string& text) {
  static const std::vector<std::pair<std::string, unsigned>> shifts = {{"", 0}, {"K", 10}, {"M", 20}, {"G", 30}};
  const char* end = text.data() + text.size();
  std::size_t count = 0;
  const auto parsed = std::from_chars(text.data(), end, count);
  const std::string unit(parsed.ptr, end);
  const auto shift = std::find_if(shifts.begin(), shifts.end(), [&](const auto& s) { return s.first == unit; });
  if (parsed.ec != std::errc{} || shift == shifts.end() ||
      count > (std::numeric_limits<std::size_t>::max() >> shift->second)) {
    throw BadValue("'" + text + "' is no amount of memory; expected bytes, perhaps with K, M or G, such as 512M");
  }
  return count << shift->second;
}

}  // namespace rmpl::tools
