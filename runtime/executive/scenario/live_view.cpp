// Rows of a screen, each cut to its width before it is coloured.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/live_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "automata/assignment_text.hpp"
#include "automata/place.hpp"
#include "base/utf8.hpp"
#include "runtime/executive/scenario/moment.hpp"

namespace rmpl::runtime {
namespace {

constexpr std::size_t margin = 11;  // columns of the word that a row begins with
constexpr std::size_t goal_rows = 3;
constexpr std::size_t most_latest = 64;

/// The text cut to so many columns, one a character.
std::string cut(const std::string& text, std::size_t width) {
  if (base::code_points(text) <= width) return text;
  std::size_t end = 0;
  for (std::size_t seen = 0; end < text.size(); ++end) {
    if (base::is_continuation(text[end])) continue;
    if (++seen == width) break;
  }
  return text.substr(0, end) + "…";
}

std::string word(std::string_view text) {
  std::string result = "  " + std::string(text);
  result.resize(margin, ' ');
  return result;
}

}  // namespace

LiveView::LiveView(const automata::Plant& plant, const automata::Program& program, const automata::Scenario& scenario,
                   base::Painter painter)
    : plant_(plant),
      program_(program),
      scenario_(scenario),
      painter_(painter),
      story_(plant, program, MomentColumn(scenario.duration, scenario.cycle), base::Painter{}, {},
             [this](const std::string& line) {
               latest_.push_back(line);
               if (latest_.size() > most_latest) latest_.pop_front();
             }),
      since_(plant.components.size()) {}

void LiveView::observe(const CycleRecord& record) {
  story_.observe(record);
  for (std::size_t c = 0; c < since_.size(); ++c) {
    if (now_.estimate.empty() || record.estimate[c] != now_.estimate[c]) since_[c] = record.time;
  }
  now_.time = record.time;
  now_.estimate = record.estimate;
  now_.probability = record.probability;
  now_.set_aside = to_text(plant_.variables, record.set_aside);
  now_.goals.clear();
  const automata::Goals& goals = record.goals;
  for (std::size_t i = 0; i < goals.goal.size(); ++i) {
    now_.goals.push_back(to_text(plant_.variables, goals.goal[i]) +
                         in_parentheses(program_.locations[goals.by[i].index()].origin));
  }
  for (const automata::GoalConstraint& constraint : goals.constraints) {
    now_.goals.push_back(to_text(constraint.formula, plant_.variables) +
                         in_parentheses(program_.locations[constraint.by.index()].origin));
  }
  now_.command = to_text(plant_.variables, automata::commanded(plant_, record.command));
  now_.why =
      record.outcome == Reconfiguration::Outcome::nothing_to_do ? "" : to_text(record.why, plant_, goals.formula());
  if (now_.command.empty() && record.outcome == Reconfiguration::Outcome::wait) now_.command = "waits";
  if (record.outcome == Reconfiguration::Outcome::no_plan) now_.command = "no plan";
}

std::string LiveView::progress(std::size_t width) const {
  const double share = std::min(1.0, now_.time.seconds() / scenario_.duration.seconds());
  const int percent = static_cast<int>(share * 100);
  const std::string of = width < 60 ? "" : " of at most " + hours_minutes_seconds(scenario_.duration);
  const std::string text = "  " + hours_minutes_seconds(now_.time) + of + "  " + std::to_string(percent) + " %";
  const std::size_t bar = width - std::min(width - 4, base::code_points(text) + 2);
  const auto full = static_cast<std::size_t>(share * static_cast<double>(bar));
  std::string done, open;
  for (std::size_t i = 0; i < bar; ++i) (i < full ? done : open) += i < full ? "━" : "─";
  return "  " + painter_.good(done) + painter_.quiet(open) + text;
}

/// Components with their modes, as many as there is room for: faults first, then what changed last.
std::vector<std::string> LiveView::believed(std::size_t width, std::size_t rows) const {
  std::vector<std::size_t> order;
  for (std::size_t c = 0; c < since_.size() && !now_.estimate.empty(); ++c) order.push_back(c);
  const auto faulty = [&](std::size_t c) { return plant_.components[c].modes[now_.estimate[c].index()].fault; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return faulty(a) != faulty(b) ? faulty(a) : since_[a] > since_[b];
  });
  std::vector<std::string> result(1);
  std::size_t used = 0;
  for (const std::size_t c : order) {
    const automata::Component& component = plant_.components[c];
    const std::string text = cut(to_text(component, now_.estimate[c]), width - margin - 3);
    const std::size_t size = base::code_points(text) + (used == 0 ? 0 : 3);
    if (used > 0 && margin + used + size > width - 2) {
      if (result.size() == rows) {
        result.back() += painter_.quiet(" …");
        break;
      }
      result.emplace_back();
      used = 0;
    }
    const bool fresh = since_[c] > automata::Ticks{} && now_.time - since_[c] <= automata::Ticks::of_seconds(10);
    result.back() += used == 0 ? "" : painter_.quiet(" · ");
    result.back() += faulty(c) ? painter_.bad(text) : fresh ? painter_.strong(text) : text;
    used += size;
  }
  result.resize(rows);
  return result;
}

std::vector<std::string> LiveView::lines(std::size_t width, std::size_t height) const {
  const std::size_t room = width - margin;
  std::vector<std::string> result{progress(width), ""};
  for (std::size_t i = 0; i < goal_rows; ++i) {
    std::string text = i < now_.goals.size() ? now_.goals[i] : "";
    if (i + 1 == goal_rows && now_.goals.size() > goal_rows) {
      text = "and " + std::to_string(now_.goals.size() - i) + " more";
    }
    if (i == 0 && text.empty()) text = "nothing";
    result.push_back(painter_.note(word(i == 0 ? "asserts" : "")) + cut(text, room));
  }
  result.push_back(painter_.note(word("commands")) + cut(now_.command.empty() ? "nothing" : now_.command, room));
  result.push_back(word("") + painter_.quiet(cut(now_.why, room)));
  char share[32];
  std::snprintf(share, sizeof share, "%.3g", std::floor(now_.probability * 1000) / 1000);
  const std::string unexplained = now_.set_aside.empty() ? "" : "; nothing explains " + now_.set_aside;
  const std::string believes = std::string("with probability ") + share;
  result.push_back(painter_.note(word("believes")) + painter_.quiet(believes) +
                   painter_.bad(cut(unexplained, room - std::min(room - 1, believes.size()))));
  const std::size_t rows = height >= 24 ? 5 : 3;
  for (const std::string& row : believed(width, rows)) result.push_back(word("") + row);
  result.emplace_back();
  const std::size_t rest = height - std::min(height, result.size() + 2);
  for (std::size_t i = 0; i < rest; ++i) {
    const std::size_t shown = std::min(rest, latest_.size());
    result.push_back(i < shown ? painter_.quiet(cut(latest_[latest_.size() - shown + i], width)) : "");
  }
  return result;
}

}  // namespace rmpl::runtime
