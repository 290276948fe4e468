// One line a change: when, what, the change, and why.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/story.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "automata/assignment_text.hpp"
#include "automata/place.hpp"
#include "runtime/executive/trace/evidence_line.hpp"
#include "runtime/executive/trace/forced.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;

constexpr std::size_t word_width = 9;

std::string padded(std::string_view text, std::size_t width) {
  std::string result(text);
  if (result.size() < width) result.append(width - result.size(), ' ');
  return result;
}

/// Of the mode by itself, whatever the other components are in; at least so much, where the belief keeps few states.
double probability_of(const Estimator& estimator, automata::ComponentId component, automata::ModeId mode) {
  double sum = 0;
  for (const BeliefEntry& entry : estimator.belief()) {
    if (entry.state.modes[component.index()] == mode) sum += entry.probability;
  }
  return sum;
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

Story::Story(const automata::Plant& plant, const automata::Program& program, MomentColumn column, base::Painter painter,
             StoryFocus focus, Tell tell)
    : plant_(plant),
      program_(program),
      column_(column),
      painter_(painter),
      focus_(std::move(focus)),
      tell_(std::move(tell)),
      command_(automata::idle_action(plant)) {}

bool Story::is_told(Component about) const {
  return !about || focus_.components.empty() ||
         std::find(focus_.components.begin(), focus_.components.end(), *about) != focus_.components.end();
}

void Story::line(automata::Ticks time, std::string_view what, const std::string& text, Component about) {
  if (time < focus_.from || time > focus_.to || !is_told(about)) return;
  tell_("  " + painter_.quiet(column_.text(time)) + "  " + padded(what, word_width) + " " + text);
}

std::string Story::text_of(Assignment assignment) const { return to_text(plant_.variables, assignment); }

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
    line(record.start, "goal", painter_.quiet("- " + text_of(goal)), component_of(goal.variable));
  }
  for (std::size_t i = 0; i < record.goal.size(); ++i) {
    const Assignment goal = record.goal[i];
    if (stands_in(goal_, goal)) continue;
    line(record.start, "goal",
         "+ " + painter_.strong(text_of(goal)) +
             painter_.quiet(in_parentheses(program_.locations[record.asserted_by[i].index()].origin)),
         component_of(goal.variable));
  }
  goal_ = record.goal;
}

/// Whether what a cycle does is about a component that is told: by its controls, by its goal, or by what it is for.
bool Story::is_action_told(const CycleRecord& record) const {
  const Reason& why = record.why;
  const auto parts = automata::commanded(plant_, record.command);
  return std::any_of(parts.begin(), parts.end(),
                     [&](Assignment part) { return is_told(component_of(part.variable)); }) ||
         (why.component && is_told(why.component)) || (why.step && is_told(why.step->component)) ||
         (why.conjunct && is_told(component_of(record.goal[*why.conjunct].variable)));
}

void Story::tell_action(const CycleRecord& record) {
  const bool again = record.command == command_;
  command_ = record.command;
  const bool waits = record.outcome == Reconfiguration::Outcome::wait;
  const bool told = is_action_told(record);
  const std::string why = to_text(record.why, plant_, automata::conjunction_of(record.goal));
  if (waits && record.why != waits_ && told) line(record.start, "wait", painter_.quiet(why), std::nullopt);
  waits_ = waits ? record.why : Reason{};
  if (again && told_again_) return;
  told_again_ = again;
  std::string text;
  for (const Assignment& part : automata::commanded(plant_, command_)) {
    text += (text.empty() ? "" : ", ") + text_of(part);
  }
  if (text.empty() || !told) return;
  line(record.start, "command", text + (again ? " (again)" : "") + painter_.quiet(why.empty() ? "" : " " + why),
       std::nullopt);
}

/// The goal that a cycle is without a plan for, with its line, what bars the way, and what would open it.
std::string Story::impasse(const CycleRecord& record, const Event& event) const {
  std::string text;
  const std::size_t goal = record.why.conjunct.value_or(0);
  if (goal < record.goal.size() && (record.why.conjunct || record.goal.size() == 1)) {
    text = "for " + text_of(record.goal[goal]) +
           in_parentheses(program_.locations[record.asserted_by[goal].index()].origin) + ": ";
  } else if (event.component) {
    text = plant_[*event.component].name + ": ";
  }
  const std::string way_out = remedy(record.why, plant_);
  return text + event.message + in_parentheses(origin_of(plant_, record.why)) + (way_out.empty() ? "" : "; " + way_out);
}

void Story::tell_events(const CycleRecord& record) {
  for (const Event& event : record.events) {
    if (std::find(events_.begin(), events_.end(), event) != events_.end()) continue;
    switch (event.kind) {
      case Event::Kind::forced:
        line(record.time, "plant",
             (is_forced_as_nominal(event, record, plant_) ? event.message : painter_.bad(event.message)) +
                 " (the executive is not told)",
             event.component);
        break;
      case Event::Kind::goal_conflict:
        line(record.start, "conflict", painter_.bad(event.message), event.component);
        break;
      case Event::Kind::no_plan:
        line(record.start, "no plan", painter_.bad(impasse(record, event)), event.component);
        break;
      case Event::Kind::inconsistent:
      case Event::Kind::cut:
        line(record.time, "surprise", painter_.bad(event.message), event.component);
        break;
      case Event::Kind::connected:
        line(record.time, "plant", event.message, event.component);
        break;
      case Event::Kind::gone:
      case Event::Kind::refused:
      case Event::Kind::late:
      case Event::Kind::flood:
      case Event::Kind::unacknowledged:
        line(record.time, "plant", painter_.bad(event.message), event.component);
        break;
      case Event::Kind::irreversible:
        break;  // the command itself is told; that it is final is for the trace
    }
  }
  events_ = record.events;
}

/// What made a diagnosis, behind a colon; nothing where no state explains what is seen, which is told by itself.
std::string Story::why_diagnosed(const CycleRecord& record, automata::ComponentId component) const {
  for (const Evidence& evidence : record.evidence) {
    if (evidence.component == component) return painter_.quiet(": " + to_text(evidence, record.estimate, plant_));
  }
  return {};
}

void Story::tell_estimate(const CycleRecord& record) {
  for (std::size_t c = 0; c < plant_.components.size(); ++c) {
    if (record.estimate[c] == estimate_[c]) continue;
    const automata::Component& component = plant_.components[c];
    const automata::Mode& to = component.modes[record.estimate[c].index()];
    const std::string change = component.name + ": " + component.modes[estimate_[c].index()].name + " -> " + to.name;
    const automata::ComponentId about(c);
    if (to.fault) {
      line(record.time, "fault",
           painter_.bad(change) + " (diagnosed with probability " +
               three_digits(probability_of(*record.estimator, about, record.estimate[c])) + ")" +
               why_diagnosed(record, about),
           about);
    } else {
      line(record.time, "estimate", change, about);
    }
  }
  estimate_ = record.estimate;
}

}  // namespace rmpl::runtime
