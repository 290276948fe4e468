// Monitors against their twin on random telemetry; CSV against what was written.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "runtime/telemetry/csv.hpp"
#include "runtime/telemetry/monitors.hpp"
#include "tests/property/draw.hpp"
#include "tests/reference/monitors.hpp"

namespace rmpl::property {
namespace {

using automata::Band;
using automata::Monitor;
using automata::Ticks;
using automata::ValueId;
using automata::VariableId;

const std::vector<std::string> channels{"P1", "P2", "T"};

double draw_number() { return static_cast<double>(up_to(0, 16)) / 2; }

/// Neighbouring bands from left to right, some left out, so that there are gaps.
Monitor draw_monitor(std::size_t attribute) {
  Monitor monitor;
  monitor.channel = pick(channels);
  const std::size_t signal = up_to(0, 3);
  if (signal == 1) monitor.minus = pick(channels);
  if (signal == 2) monitor.over = Ticks::of_seconds(static_cast<std::int64_t>(up_to(1, 4)));
  monitor.attribute = VariableId(attribute);
  double from = signal == 0 || signal == 3 ? 0 : -4;
  for (std::size_t b = 0; b < 4; ++b) {
    Band band;
    band.value = ValueId(up_to(0, 2));
    band.from = from;
    band.to = from + static_cast<double>(up_to(0, 3));
    if (b == 0 && chance(50)) {
      band.from = -std::numeric_limits<double>::infinity();
      band.open_to = true;
    }
    if (b == 3 && chance(50)) {
      band.open_from = true;
      band.to = std::numeric_limits<double>::infinity();
    }
    from = (std::isfinite(band.to) ? band.to : from) + (chance(30) ? 1 : 0);
    if (chance(80)) monitor.bands.push_back(band);
  }
  if (signal == 0 && chance(40))
    monitor.literals = {{ValueId(std::size_t{0}), "ON", {}}, {ValueId(std::size_t{1}), {}, 20.0}};
  if (chance(40)) monitor.hysteresis = draw_number() / 4;
  if (chance(40)) monitor.persist_samples = up_to(1, 4);
  if (chance(30)) monitor.persist_time = Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 4)));
  if (chance(40)) monitor.stale = Ticks::of_seconds(static_cast<std::int64_t>(up_to(1, 5)));
  return monitor;
}

reference::ChannelSaid draw_sample(Ticks time) {
  reference::ChannelSaid said{time, pick(channels), {}, draw_number()};
  if (chance(10)) said.number = 20;
  if (chance(5)) said.number = std::numeric_limits<double>::quiet_NaN();
  if (chance(3)) said.number = std::numeric_limits<double>::infinity();
  if (chance(10)) {
    said.number.reset();
    said.text = chance(60) ? "ON" : "n/a";
  }
  return said;
}

RC_GTEST_PROP(Monitors, SayWhatTheirDefinitionSays, ()) {
  std::vector<Monitor> monitors;
  for (std::size_t m = 0; m < up_to(1, 3); ++m) monitors.push_back(draw_monitor(m));
  runtime::Monitors fast(monitors);
  std::vector<reference::ChannelSaid> said;
  Ticks now;
  for (std::size_t s = 0; s < up_to(1, 24); ++s) {
    now += Ticks{static_cast<std::int64_t>(up_to(0, 6)) * Ticks::per_second / 2};
    const reference::ChannelSaid sample = draw_sample(now);
    if (const auto channel = fast.find(sample.channel)) {
      const runtime::Sample taken{*channel, sample.number, sample.text};
      fast.take({&taken, 1}, now);
      said.push_back(sample);
    }
    if (chance(30)) now += Ticks{static_cast<std::int64_t>(up_to(0, 14)) * Ticks::per_second / 2};
    RC_ASSERT(fast.readings(now) == reference::readings(monitors, said, now));
  }
}

RC_GTEST_PROP(Csv, ReadsWhatWasWritten, ()) {
  const char delimiter = pick(std::vector<char>{',', ';', '\t'});
  const std::vector<std::string> cells{"",           "1.5",        "a b",          "a,b", "a;b",
                                       "say \"on\"", "two\nlines", "two\r\nlines", "\t",  "é"};
  const std::size_t width = up_to(2, 4);
  std::vector<std::vector<std::string>> rows(up_to(1, 6), std::vector<std::string>(width));
  std::string text = chance(20) ? "\xEF\xBB\xBF" : "";
  for (auto& row : rows) {
    for (std::size_t c = 0; c < width; ++c) {
      row[c] = pick(cells);
      const bool special = row[c].find_first_of(",;\t\"\r\n") != std::string::npos;
      if (c > 0) text += delimiter;
      if (special || chance(20)) {
        text += '"';
        for (const char letter : row[c]) text += letter == '"' ? std::string("\"\"") : std::string(1, letter);
        text += '"';
      } else {
        text += row[c];
      }
    }
    text += chance(50) ? "\r\n" : "\n";
  }
  std::istringstream in(text);
  runtime::CsvReader reader(in, "x.csv", delimiter);
  for (const auto& row : rows) {
    const runtime::CsvRow* read = reader.next();
    RC_ASSERT(read != nullptr && read->size() == width);
    for (std::size_t c = 0; c < width; ++c) RC_ASSERT((*read)[c] == row[c]);
  }
  RC_ASSERT(reader.next() == nullptr);
}

}  // namespace
}  // namespace rmpl::property
