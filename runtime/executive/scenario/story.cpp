// One line a change: when, what, the change, and why.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/story.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "runtime/executive/trace/place.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;

constexpr std::size_t word_width = 9;

std::string padded(std::string_view text, std::size_t width) {
  std::string result(text);
  if (result.size() < width) result.append(width - result.size(), ' ');
  return result;
}

/// A probability with three significant digits; `1` only where it is 1.
std::string three_digits(double probability) {
  if (probability < 1 && probability > 0.9995) return ">0.999";
  std::array<char, 32> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), probability, std::chars_format::general, 3);
  return {digits.data(), end.ptr};
}

}  // namespace

Story::Story(const automata::Plant& plant, const automata::Program& program, MomentColumn column, Style style,
             StoryFocus focus, Tell tell)
    : plant_(plant),
      program_(program),
      column_(column),
      style_(style),
      focus_(std::move(focus)),
      tell_(std::move(tell)),
      command_(automata::idle_action(plant)) {}

bool Story::is_told(Component about) const {
  return !about || focus_.components.empty() ||
         std::find(focus_.components.begin(), focus_.components.end(), *about) != focus_.components.end();
}

void Story::line(automata::Ticks time, std::string_view what, const std::string& text, Component about) {
  if (time < focus_.from || time > focus_.to || !is_told(about)) return;
  tell_("  " + style_.quiet(column_.text(time)) + "  " + padded(what, word_width) + " " + text);
}

std::string Story::text_of(Assignment assignment) const {
  return plant_.variables.name(assignment.variable) + " = " + plant_.variables.value(assignment);
}

/// The component that a variable belongs to by its name, `component.attribute`, if it belongs to one.
Story::Component Story::component_of(automata::VariableId variable) const {
  if (const auto component = plant_.component_of(variable)) return component;
  const std::string& name = plant_.variables.name(variable);
  return plant_.find_component(name.substr(0, name.rfind('.')));
}

void Story::observe(const CycleRecord& record) {
  if (record.cycle == 0) {
    estimate_ = record.estimate;
  } else {
    tell_goals(record);
    tell_action(record);
  }
  tell_events(record);
  tell_estimate(record);
}

void Story::tell_goals(const CycleRecord& record) {
  if (record.goal == goal_) return;
  const auto stands_in = [](const std::vector<Assignment>& goals, Assignment goal) {
    return std::find(goals.begin(), goals.end(), goal) != goals.end();
  };
  for (const Assignment& goal : goal_) {
    if (stands_in(record.goal, goal)) continue;
    line(record.start, "goal", style_.quiet("- " + text_of(goal)), component_of(goal.variable));
  }
  for (std::size_t i = 0; i < record.goal.size(); ++i) {
    const Assignment goal = record.goal[i];
    if (stands_in(goal_, goal)) continue;
    line(record.start, "goal",
         "+ " + style_.strong(text_of(goal)) +
             style_.quiet(in_parentheses(program_.locations[record.asserted_by[i].index()].origin)),
         component_of(goal.variable));
  }
  goal_ = record.goal;
}

void Story::tell_action(const CycleRecord& record) {
  const bool again = record.command == command_;
  command_ = record.command;
  const std::string why = to_text(record.why, plant_, automata::conjunction_of(record.goal));
  if (record.outcome == Reconfiguration::Outcome::wait) {
    if (record.why != waits_) line(record.start, "wait", style_.quiet(why), record.why.component);
    waits_ = record.why;
  } else {
    waits_ = {};
  }
  if (again && told_again_) return;
  told_again_ = again;
  std::string text;
  Component about;
  bool told = false;
  for (const Assignment& part : automata::commanded(plant_, command_)) {
    text += (text.empty() ? "" : ", ") + text_of(part);
    about = component_of(part.variable);
    told = told || is_told(about);
  }
  if (text.empty()) return;
  if (!told && record.why.component) about = record.why.component;
  if (!told && record.why.step && !is_told(about)) about = record.why.step->component;
  line(record.start, "command", text + (again ? " (again)" : "") + style_.quiet(why.empty() ? "" : " " + why),
       told ? std::nullopt : about);
}

void Story::tell_events(const CycleRecord& record) {
  for (const Event& event : record.events) {
    if (std::find(events_.begin(), events_.end(), event) != events_.end()) continue;
    const std::string text = event.component && event.kind == Event::Kind::no_plan
                                 ? plant_[*event.component].name + ": " + event.message
                                 : event.message;
    switch (event.kind) {
      case Event::Kind::forced:
        line(record.time, "plant", style_.bad(text) + " (the executive is not told)", event.component);
        break;
      case Event::Kind::goal_conflict:
        line(record.start, "conflict", style_.bad(text), event.component);
        break;
      case Event::Kind::no_plan:
        line(record.start, "no plan", style_.bad(text), event.component);
        break;
      case Event::Kind::inconsistent:
      case Event::Kind::cut:
        line(record.time, "surprise", style_.bad(text), event.component);
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
    const automata::ComponentId about(c);
    if (to.fault) {
      line(record.time, "fault",
           style_.bad(change) + " (diagnosed with probability " + three_digits(record.probability) + ")", about);
    } else {
      line(record.time, "estimate", change, about);
    }
  }
  estimate_ = record.estimate;
}

}  // namespace rmpl::runtime
