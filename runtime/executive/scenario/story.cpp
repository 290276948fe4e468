// One line a change: when, what, the change, and why.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/story.hpp"

#include <algorithm>
#include <utility>

#include "automata/assignment_text.hpp"
#include "automata/owner.hpp"
#include "automata/place.hpp"
#include "runtime/executive/trace/evidence_line.hpp"
#include "runtime/executive/trace/forced.hpp"
#include "runtime/executive/trace/three_digits.hpp"

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

}  // namespace

Story::Story(const automata::Plant& plant, const automata::Program& program, MomentColumn column, base::Painter painter,
             StoryFocus focus, Tell tell)
    : plant_(plant),
      program_(program),
      column_(column),
      painter_(painter),
      focus_(std::move(focus)),
      tell_(std::move(tell)),
      samples_(plant),
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

void Story::observe(const CycleRecord& record) {
  if (record.cycle == 0) {
    estimate_ = record.estimate;
  } else {
    tell_goals(record);
    tell_action(record);
  }
  tell_events(record);
  tell_samples(record);
  tell_estimate(record);
}

void Story::tell_goals(const CycleRecord& record) {
  const automata::Goals& goals = record.goals;
  if (goals == goals_) return;
  const auto stands_in = [](const std::vector<Assignment>& modes, Assignment goal) {
    return std::find(modes.begin(), modes.end(), goal) != modes.end();
  };
  const auto stands_among = [](const std::vector<automata::GoalConstraint>& constraints,
                               const automata::GoalConstraint& constraint) {
    return std::any_of(constraints.begin(), constraints.end(),
                       [&](const automata::GoalConstraint& other) { return other.formula == constraint.formula; });
  };
  for (const Assignment& goal : goals_.goal) {
    if (stands_in(goals.goal, goal)) continue;
    line(record.start, "goal", painter_.quiet("- " + text_of(goal)), automata::owner_of(plant_, goal.variable));
  }
  for (const automata::GoalConstraint& gone : goals_.constraints) {
    if (stands_among(goals.constraints, gone)) continue;
    line(record.start, "goal", painter_.quiet("- " + to_text(gone.formula, plant_.variables)), std::nullopt);
  }
  for (std::size_t i = 0; i < goals.goal.size(); ++i) {
    const Assignment goal = goals.goal[i];
    if (stands_in(goals_.goal, goal)) continue;
    line(record.start, "goal",
         "+ " + painter_.strong(text_of(goal)) +
             painter_.quiet(in_parentheses(program_.locations[goals.by[i].index()].origin)),
         automata::owner_of(plant_, goal.variable));
  }
  for (const automata::GoalConstraint& constraint : goals.constraints) {
    if (stands_among(goals_.constraints, constraint)) continue;
    line(record.start, "goal",
         "+ " + painter_.strong(to_text(constraint.formula, plant_.variables)) +
             painter_.quiet(in_parentheses(program_.locations[constraint.by.index()].origin)),
         std::nullopt);
  }
  goals_ = goals;
}

/// Whether what a cycle does is about a component that is told: by its controls, by its goal, or by what it is for.
bool Story::is_action_told(const CycleRecord& record) const {
  const Reason& why = record.why;
  const auto parts = automata::commanded(plant_, record.command);
  return std::any_of(parts.begin(), parts.end(),
                     [&](Assignment part) { return is_told(automata::owner_of(plant_, part.variable)); }) ||
         (why.component && is_told(why.component)) || (why.step && is_told(why.step->component)) ||
         (why.conjunct && *why.conjunct < record.goals.goal.size() &&
          is_told(automata::owner_of(plant_, record.goals.goal[*why.conjunct].variable)));
}

void Story::tell_action(const CycleRecord& record) {
  const bool again = record.command == command_;
  command_ = record.command;
  const bool waits = record.outcome == Reconfiguration::Outcome::wait;
  const bool told = is_action_told(record);
  const std::string why = to_text(record.why, plant_, record.goals.formula());
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

/// `for a = on (main.rmpl:3): `: the conjunct that has no plan, where one can be named.
std::string Story::goal_without_plan(const automata::Goals& goals, const Reason& why) const {
  const std::size_t modes = goals.goal.size();
  const std::size_t all = modes + goals.constraints.size();
  const std::size_t conjunct = why.conjunct.value_or(0);
  if (conjunct >= all || (!why.conjunct && all != 1)) return {};
  const bool mode = conjunct < modes;
  const automata::LocationId by = mode ? goals.by[conjunct] : goals.constraints[conjunct - modes].by;
  return "for " +
         (mode ? text_of(goals.goal[conjunct])
               : to_text(goals.constraints[conjunct - modes].formula, plant_.variables)) +
         in_parentheses(program_.locations[by.index()].origin) + ": ";
}

/// The goal that a cycle is without a plan for, with its line, what bars the way, and what would open it.
std::string Story::impasse(const CycleRecord& record, const Event& event) const {
  // One of several goals that are asked for by themselves, or all that are asked for.
  const auto left_out = std::find_if(record.left_out.begin(), record.left_out.end(), [&](const LeftOut& other) {
    return other.reason == event.message && other.component == event.component;
  });
  const bool one = left_out != record.left_out.end();
  const Reason& why = one ? left_out->why : record.why;
  std::string text = goal_without_plan(one ? left_out->goals : record.goals, why);
  if (text.empty() && event.component) text = plant_[*event.component].name + ": ";
  const std::string way_out = remedy(why, plant_);
  return text + event.message + in_parentheses(origin_of(plant_, why)) + (way_out.empty() ? "" : "; " + way_out);
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
      case Event::Kind::commanded:
        line(record.start, "operator", event.message, event.component);
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
  const auto surprised = [](const std::vector<Event>& events) {
    return std::any_of(events.begin(), events.end(),
                       [](const Event& e) { return e.kind == Event::Kind::inconsistent; });
  };
  if (surprised(events_) && !surprised(record.events)) {
    line(record.time, "surprise", painter_.quiet("over: the estimate uses every reading again"), std::nullopt);
  }
  events_ = record.events;
}

void Story::tell_samples(const CycleRecord& record) {
  for (const SampleStory::Line& told : samples_.lines(record)) line(record.time, "sample", told.text, told.about);
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
      const double probability = probability_of(*record.estimator, about, record.estimate[c]);
      // A trace need not have the belief.
      const std::string with = probability > 0 ? " with probability " + three_digits(probability) : "";
      line(record.time, "fault", painter_.bad(change) + " (diagnosed" + with + ")" + why_diagnosed(record, about),
           about);
    } else {
      line(record.time, "estimate", change, about);
    }
  }
  estimate_ = record.estimate;
}

}  // namespace rmpl::runtime
