// Few marks, and words beside each: what a picture shows can be read without it.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/campaign_plots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

#include "automata/assignment_text.hpp"
#include "automata/time/time.hpp"

namespace rmpl::tools {
namespace {

using automata::Ticks;

constexpr double width = 720;  // of the pictures, in their own units

/// With one decimal at most: the same bytes everywhere.
std::string place(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", number);
  return text.data();
}

std::string picture(double height, const std::string& says, const std::string& marks) {
  return "<svg role=\"img\" aria-label=\"" + escaped(says) + "\" viewBox=\"0 0 " + place(width) + " " + place(height) +
         "\" width=\"" + place(width) + "\" height=\"" + place(height) + "\">\n" + marks + "</svg>\n";
}

std::string box(double x, double y, double w, double h, const char* kind, const std::string& title) {
  return "<rect class=\"" + std::string(kind) + "\" x=\"" + place(x) + "\" y=\"" + place(y) + "\" width=\"" + place(w) +
         "\" height=\"" + place(h) + "\"><title>" + escaped(title) + "</title></rect>\n";
}

std::string words(double x, double y, const char* anchor, const std::string& text) {
  return "<text x=\"" + place(x) + "\" y=\"" + place(y) + "\" text-anchor=\"" + anchor + "\">" + escaped(text) +
         "</text>\n";
}

std::string seconds(Ticks time) {
  return (time.count < 0 ? "-" : "") + automata::format_seconds({std::abs(time.count)}) + " s";
}

std::string runs(std::uint64_t count) { return std::to_string(count) + (count == 1 ? " run" : " runs"); }

/// The smallest of 1, 2 and 5 times a power of ten nanoseconds that is not below.
Ticks round_up(std::int64_t least) {
  for (std::int64_t unit = 1; unit <= std::int64_t{1'000'000'000'000'000'000} / 10; unit *= 10) {
    for (const std::int64_t times : {1, 2, 5}) {
      if (unit * times >= least) return {unit * times};
    }
  }
  return {least};
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '&') {
      result += "&amp;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

std::string outcome_plot(const Outcomes& outcomes) {
  struct Part {
    std::uint64_t count;
    const char* kind;
    const char* word;
  };
  const std::array<Part, 4> parts = {Part{outcomes.met, "met", "met"}, Part{outcomes.failed, "failed", "failed"},
                                     Part{outcomes.undecided, "undecided", "undecided"},
                                     Part{outcomes.impossible, "impossible", "impossible for the model"}};
  std::uint64_t all = 0;
  for (const Part& part : parts) all += part.count;
  if (all == 0) return "";
  std::string marks, says;
  double x = 0, y = 52;
  for (const Part& part : parts) {
    if (part.count == 0) continue;
    const double share = width * static_cast<double>(part.count) / static_cast<double>(all);
    const std::string text = runs(part.count) + " " + part.word;
    marks +=
        box(x, 4, share, 24, part.kind, text) + box(0, y - 11, 12, 12, part.kind, text) + words(20, y, "start", text);
    says += (says.empty() ? "" : ", ") + text;
    x += share;
    y += 20;
  }
  return picture(y - 8, "What came of the runs: " + says, marks);
}

std::string latency_plot(std::vector<Ticks> latencies) {
  if (latencies.empty()) return "";
  std::sort(latencies.begin(), latencies.end());
  constexpr std::int64_t most_bars = 24;
  constexpr double height = 120, bottom = 132;
  const Ticks first = latencies.front(), last = latencies.back();
  if (first == last) {
    const std::string all =
        std::to_string(latencies.size()) + (latencies.size() == 1 ? "" : ", each") + " of " + seconds(first);
    return picture(24, "Latencies of diagnosis: " + all, words(0, 16, "start", all + " from symptom to name"));
  }
  const Ticks bar = round_up(std::max<std::int64_t>((last.count - first.count) / most_bars + 1, 1));
  const auto floor_of = [&](Ticks time) {
    return time.count >= 0 ? time.count / bar.count : -((-time.count + bar.count - 1) / bar.count);
  };
  const std::int64_t low = floor_of(first);
  std::vector<std::uint64_t> counts(static_cast<std::size_t>(floor_of(last) - low + 1));
  for (const Ticks time : latencies) ++counts[static_cast<std::size_t>(floor_of(time) - low)];
  const std::uint64_t most = *std::max_element(counts.begin(), counts.end());
  const double each = std::min(width / static_cast<double>(counts.size()), 60.0);
  std::string marks;
  for (std::size_t b = 0; b < counts.size(); ++b) {
    if (counts[b] == 0) continue;
    const double tall = height * static_cast<double>(counts[b]) / static_cast<double>(most);
    const Ticks from{(low + static_cast<std::int64_t>(b)) * bar.count};
    marks += box(each * static_cast<double>(b) + 1, bottom - tall, each - 2, tall, "bar",
                 std::to_string(counts[b]) + " from " + seconds(from) + " to " + seconds(from + bar));
  }
  const double right = each * static_cast<double>(counts.size());
  marks += "<path class=\"axis\" d=\"M0 " + place(bottom) + "H" + place(right) + "\"/>\n";
  marks += words(0, bottom + 16, "start", seconds({low * bar.count}));
  const std::string end =
      seconds({(low + static_cast<std::int64_t>(counts.size())) * bar.count}) + " from symptom to name";
  constexpr double room = 320;  // for both labels below the axis; else the second one stands behind it
  marks += right < room ? words(right + 8, bottom + 4, "start", end) : words(right, bottom + 16, "end", end);
  marks += words(0, 10, "start", "at most " + std::to_string(most) + " in a bar of " + seconds(bar));
  const Ticks median = latencies[latencies.size() / 2];
  return picture(bottom + 24,
                 "Latencies of diagnosis: " + std::to_string(latencies.size()) + " from " + seconds(first) + " to " +
                     seconds(last) + ", median " + seconds(median),
                 marks);
}

std::string failure_plot(const std::vector<runtime::CampaignRun>& failed, const automata::Plant& plant) {
  struct Mark {
    Ticks time;
    std::uint64_t run;
  };
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Mark>> rows;
  Ticks end;
  for (const runtime::CampaignRun& run : failed) {
    end = std::max(end, run.time);
    for (const runtime::Injected& injected : run.injected) {
      if (!injected.forced) continue;
      rows[{injected.fault.component.index(), injected.fault.mode.index()}].push_back({*injected.forced, run.run});
      end = std::max(end, *injected.forced);
    }
  }
  if (rows.empty() || end.count == 0) return "";
  constexpr double left = 240, tall = 20;
  std::string marks;
  double y = 0;
  for (const auto& [fault, times] : rows) {
    const std::string name = to_text(plant.components[fault.first], automata::ModeId(fault.second));
    constexpr std::size_t room = 34;
    marks += words(left - 8, y + 14, "end", name.size() > room ? name.substr(0, room - 1) + "…" : name);
    marks += "<path class=\"axis\" d=\"M" + place(left) + " " + place(y + 10) + "H" + place(width) + "\"/>\n";
    for (const Mark& mark : times) {
      const double share = static_cast<double>(mark.time.count) / static_cast<double>(end.count);
      marks += box(left + (width - left - 4) * share, y + 3, 4, 14, "failed",
                   "run " + std::to_string(mark.run) + ": " + name + " at " + seconds(mark.time));
    }
    y += tall;
  }
  marks += words(left, y + 14, "start", "0 s") + words(width, y + 14, "end", seconds(end));
  return picture(y + 20, "When the faults of failing runs happened, a row for each fault", marks);
}

}  // namespace rmpl::tools
