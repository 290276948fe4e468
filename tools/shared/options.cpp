// Reading the texts of options.
// SPDX-License-Identifier: MIT
#include "tools/shared/options.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

namespace rmpl::tools {

using automata::Ticks;

void add_common(CLI::App& app, Common& common) {
  add_choice<Color>(app, "--color", common.color,
                    {{"auto", Color::automatic}, {"always", Color::always}, {"never", Color::never}},
                    "colours; auto, the default, is on a terminal where NO_COLOR is not set");
  add_read(app, "--max-input", common.max_input, memory_size,
           "the longest file, or line of a log, that is read (default 1G)")
      ->option_text("BYTES[K|M|G]");
  app.add_flag("-q,--quiet", common.quiet, "say less: no warnings, no progress, no story");
  app.add_flag("-v,--verbose", common.verbose, "say more: what is read, and what it cost");
}

void add_format(CLI::App& app, Common& common, bool junit) {
  std::vector<std::pair<std::string, Format>> forms{{"text", Format::text}, {"json", Format::json}};
  if (junit) forms.emplace_back("junit", Format::junit);
  add_choice<Format>(app, "--format", common.format, forms,
                     junit ? "text for people (the default), json for programs, junit for continuous integration"
                           : "text for people (the default), json for programs");
}

CLI::Option* repeatable(CLI::Option* option) { return option->expected(1)->take_all()->allow_extra_args(false); }

void require_one(CLI::App& command, CLI::Option* one, CLI::Option* other) {
  one->excludes(other);
  command.parse_complete_callback([one, other] {
    if (one->count() + other->count() > 0) return;
    throw CLI::ValidationError("expected " + one->get_name() + " or " + other->get_name());
  });
}

std::uint64_t whole_number(const std::string& text, std::uint64_t least, std::uint64_t most) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, number);
  if (parsed.ec == std::errc{} && parsed.ptr == end && number >= least && number <= most) return number;
  const bool any = most == std::numeric_limits<std::uint64_t>::max();
  throw CLI::ValidationError("expected a whole number from " + std::to_string(least) + " to " +
                             (any ? std::string("2^64 - 1") : std::to_string(most)) + ", not '" + text + "'");
}

Ticks duration(const std::string& text) {
  if (const auto ticks = automata::parse_duration(text)) return *ticks;
  throw CLI::ValidationError(
      "'" + text +
      "' is no duration; expected a number and perhaps a unit (us, ms, s, min, h or d), as in 30, "
      "5ms or 4.5h, of less than 292 years");
}

Ticks positive_duration(const std::string& text) {
  const Ticks ticks = duration(text);
  if (ticks > Ticks{0} && !ticks.is_infinite()) return ticks;
  throw CLI::ValidationError("'" + text + "' is no length of time; expected a finite duration above 0");
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
    throw CLI::ValidationError("'" + text +
                               "' is no amount of memory; expected bytes, perhaps with K, M or G, such as 512M");
  }
  return count << shift->second;
}

}  // namespace rmpl::tools
