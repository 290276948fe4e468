// Rows of a table whose last column may be of any width.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/scenario_table.hpp"

#include <algorithm>
#include <array>
#include <utility>

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
std::string count(const std::vector<ScenarioOutcome>& outcomes, base::Painter painter) {
  std::array<std::size_t, 3> verdicts{};
  std::size_t scenarios = 0, not_flown = 0, wrong = 0, not_read = 0;
  for (const ScenarioOutcome& outcome : outcomes) {
    if (outcome.flown != nullptr) {
      ++verdicts[static_cast<std::size_t>(outcome.flown->result.verdict())];
    } else {
      ++(outcome.wrong() ? wrong : outcome.scenario == nullptr ? not_read : not_flown);
    }
    if (outcome.scenario != nullptr) ++scenarios;
  }
  const auto number = [](std::size_t n, const std::string& what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
  };
  std::string text;
  const auto tell = [&](std::size_t n, std::string_view what, bool bad) {
    if (n == 0) return;
    const std::string part = (n == scenarios && n > 1 ? "all" : std::to_string(n)) + " " + std::string(what);
    text += (text.empty() ? "" : ", ") + (bad ? painter.bad(part) : painter.good(part));
  };
  tell(verdicts[static_cast<std::size_t>(Verdict::met)], "met", false);
  tell(verdicts[static_cast<std::size_t>(Verdict::failed)], "failed", true);
  tell(verdicts[static_cast<std::size_t>(Verdict::undecided)], "undecided", true);
  tell(not_flown, "not flown", true);
  text = number(scenarios, "scenario") + (text.empty() ? "" : ": ") + text;
  if (wrong > 0) text += "; " + painter.bad(number(wrong, "file") + " wrong");
  if (not_read > 0) text += "; " + painter.bad(number(not_read, "file") + " not read");
  return text + "\n";
}

/// `met`, `FAILED`, … of one width.
std::string word(const Flown* flown, base::Painter painter) {
  return flown == nullptr ? painter.strong("not flown") : runtime::verdict_word(flown->result.verdict(), painter);
}

}  // namespace

std::string to_table(const std::vector<ScenarioOutcome>& outcomes, TableDetail detail, base::Painter painter) {
  Column times;
  const auto time_of = [](const ScenarioOutcome& outcome) {
    return outcome.flown == nullptr ? "" : runtime::hours_minutes_seconds(outcome.flown->result.time);
  };
  for (const ScenarioOutcome& outcome : outcomes) times.make_room(time_of(outcome));
  std::string text;
  const ScenarioFile* file = nullptr;
  for (const ScenarioOutcome& outcome : outcomes) {
    const bool met = outcome.flown != nullptr && outcome.flown->result.verdict() == Verdict::met;
    if (met && detail == TableDetail::failures) continue;
    if (outcome.scenario == nullptr) {
      text += painter.strong(outcome.file->path) + ": " +
              (outcome.wrong() ? painter.bad("WRONG, nothing of it was flown") : painter.strong("not read")) + "\n";
      continue;
    }
    if (std::exchange(file, outcome.file) != outcome.file) text += painter.strong(outcome.file->path) + "\n";
    text += "  " + word(outcome.flown, painter) + "  " + painter.quiet(times.text(time_of(outcome))) + "  " +
            outcome.scenario->name + "\n";
    if (detail == TableDetail::verdicts || outcome.flown == nullptr) continue;
    const std::vector<Judgement>& judgements = outcome.flown->result.judgements;
    for (std::size_t i = 0; i < judgements.size(); ++i) {
      if (judgements[i].verdict == Verdict::met) continue;
      text += "  " + runtime::summary_line(outcome.scenario->expectations[i], judgements[i], painter);
    }
  }
  return text + count(outcomes, painter);
}

}  // namespace rmpl::tools
