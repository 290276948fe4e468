// Rows of a table whose last column may be of any width.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/scenario_table.hpp"

#include <algorithm>
#include <array>

#include "runtime/executive/scenario/moment.hpp"
#include "runtime/executive/scenario/report.hpp"

namespace rmpl::tools {
namespace {

using runtime::Judgement;
using Verdict = Judgement::Verdict;

/// Times below each other, by their points.
class Column {
 public:
  void make_room(const std::string& time) {
    before_ = std::max(before_, point(time));
    after_ = std::max(after_, time.size() - point(time));
  }
  [[nodiscard]] std::string text(const std::string& time) const {
    const std::size_t left = before_ - point(time);
    return std::string(left, ' ') + time + std::string(before_ + after_ - left - time.size(), ' ');
  }

 private:
  static std::size_t point(const std::string& time) { return std::min(time.find('.'), time.size()); }
  std::size_t before_ = 0, after_ = 0;
};

/// `13 scenarios: 12 met, 1 failed`.
std::string count(const std::vector<Task>& tasks, const std::vector<Flown>& flights, base::Painter painter) {
  std::array<std::size_t, 3> counts{};
  for (const Flown& flown : flights) ++counts[static_cast<std::size_t>(flown.result.verdict())];
  const std::size_t open = tasks.size() - flights.size();
  std::string text;
  const auto tell = [&](std::size_t number, std::string_view what, bool bad) {
    if (number == 0) return;
    const std::string part = (number == tasks.size() ? "all" : std::to_string(number)) + " " + std::string(what);
    text += (text.empty() ? "" : ", ") + (bad ? painter.bad(part) : painter.good(part));
  };
  tell(counts[static_cast<std::size_t>(Verdict::met)], "met", false);
  tell(counts[static_cast<std::size_t>(Verdict::failed)], "failed", true);
  tell(counts[static_cast<std::size_t>(Verdict::undecided)], "undecided", true);
  tell(open, "not flown", true);
  return std::to_string(tasks.size()) + " scenarios: " + text + "\n";
}

}  // namespace

std::string to_table(const std::vector<Task>& tasks, const std::vector<Flown>& flights, bool reasons,
                     base::Painter painter) {
  Column times;
  for (const Flown& flown : flights) times.make_room(runtime::hours_minutes_seconds(flown.result.time));
  std::string text;
  for (std::size_t f = 0; f < flights.size(); ++f) {
    if (f == 0 || tasks[f].file != tasks[f - 1].file) text += painter.strong(tasks[f].file) + "\n";
    const Flown& flown = flights[f];
    text += "  " + runtime::verdict_word(flown.result.verdict(), painter) + "  " +
            painter.quiet(times.text(runtime::hours_minutes_seconds(flown.result.time))) + "  " + flown.scenario->name +
            "\n";
    if (!reasons) continue;
    for (std::size_t i = 0; i < flown.result.judgements.size(); ++i) {
      if (flown.result.judgements[i].verdict == Verdict::met) continue;
      text += "  " + runtime::summary_line(flown.scenario->expectations[i], flown.result.judgements[i], painter);
    }
  }
  return text + count(tasks, flights, painter);
}

}  // namespace rmpl::tools
