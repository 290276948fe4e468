// One line a change: time, what, and the change.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/story.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace rmpl::runtime {
namespace {

constexpr std::size_t time_width = 12;
constexpr std::size_t word_width = 9;

std::string padded(std::string_view text, std::size_t width) {
  std::string result(text);
  if (result.size() < width) result.append(width - result.size(), ' ');
  return result;
}

/// A probability with three significant digits; `1` only where it is 1.
std::string percent(double probability) {
  if (probability < 1 && probability > 0.9995) return ">0.999";
  std::array<char, 32> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), probability, std::chars_format::general, 3);
  return {digits.data(), end.ptr};
}

}  // namespace

Story::Story(const automata::Plant& plant, Style style, Tell tell)
    : plant_(plant), style_(style), tell_(std::move(tell)), command_(automata::idle_action(plant)) {}

void Story::line(automata::Ticks time, std::string_view what, const std::string& text) {
  const std::string seconds = automata::format_seconds(time) + " s";
  const std::string indent(time_width - std::min(time_width, seconds.size()), ' ');
  tell_(indent + style_.quiet(seconds) + "  " + padded(what, word_width) + " " + text);
}

std::string Story::text_of(automata::Assignment assignment) const {
  return plant_.variables.name(assignment.variable) + " = " + plant_.variables.value(assignment);
}

void Story::observe(const CycleRecord& record) {
  if (record.cycle == 0) {
    estimate_ = record.estimate;
  } else {
    tell_goal(record);
    tell_command(record);
  }
  tell_events(record);
  tell_estimate(record);
}

void Story::tell_goal(const CycleRecord& record) {
  if (record.goal == goal_) return;
  goal_ = record.goal;
  std::string text;
  for (const automata::Assignment& goal : goal_) text += (text.empty() ? "" : ", ") + text_of(goal);
  if (!text.empty()) line(record.start, "goal", style_.strong(text));
}

void Story::tell_command(const CycleRecord& record) {
  if (record.command == command_) return;
  command_ = record.command;
  std::string text;
  for (const automata::Assignment& part : automata::commanded(plant_, command_)) {
    text += (text.empty() ? "" : ", ") + text_of(part);
  }
  if (!text.empty()) line(record.start, "command", text);
}

void Story::tell_events(const CycleRecord& record) {
  for (const Event& event : record.events) {
    if (std::find(events_.begin(), events_.end(), event) != events_.end()) continue;
    const std::string text = event.component && event.kind == Event::Kind::no_plan
                                 ? plant_[*event.component].name + ": " + event.message
                                 : event.message;
    switch (event.kind) {
      case Event::Kind::forced:
        line(record.time, "plant", style_.bad(text) + " (the executive is not told)");
        break;
      case Event::Kind::goal_conflict:
        line(record.start, "conflict", style_.bad(text));
        break;
      case Event::Kind::no_plan:
        line(record.start, "no plan", style_.bad(text));
        break;
      case Event::Kind::inconsistent:
      case Event::Kind::cut:
        line(record.time, "surprise", style_.bad(text));
        break;
      case Event::Kind::irreversible:
        break;  // the command itself is told; that it is final is for the trace
    }
  }
  events_ = record.events;
}

void Story::tell_estimate(const CycleRecord& record) {
  for (std::size_t c = 0; c < estimate_.size(); ++c) {
    if (record.estimate[c] == estimate_[c]) continue;
    const automata::Component& component = plant_.components[c];
    const automata::Mode& to = component.modes[record.estimate[c].index()];
    const std::string change = component.name + ": " + component.modes[estimate_[c].index()].name + " -> " + to.name;
    if (to.fault) {
      line(record.time, "fault",
           style_.bad(change) + " (diagnosed with probability " + percent(record.probability) + ")");
    } else {
      line(record.time, "estimate", change);
    }
  }
  estimate_ = record.estimate;
}

}  // namespace rmpl::runtime
