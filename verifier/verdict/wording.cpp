// Verdicts in words.
// SPDX-License-Identifier: MIT
#include "verifier/verdict/wording.hpp"

#include <cstdio>

#include "automata/assignment_text.hpp"
#include "base/overloaded.hpp"
#include "base/painter.hpp"
#include "verifier/verdict/cause.hpp"
#include "verifier/verdict/trace.hpp"

namespace rmpl::verifier {

using Kind = ProgramProperty::Kind;

namespace {

std::string_view limit_text(Limit limit) {
  switch (limit) {
    case Limit::states:
      return "the limit of states (--max-states) was reached";
    case Limit::time:
      return "the limit of time (--timeout) was reached";
    case Limit::memory:
      return "the limit of memory (--max-memory) was reached";
    case Limit::interrupt:
      return "interrupted";
    case Limit::plan:
      return "the planner stopped before it proved its plan optimal";
  }
  return "";
}

std::string stuck_text(bool violated) {
  return violated ? "some runs end in a deadlock or a timelock" : "no run ends in a deadlock or a timelock";
}

/// ` from 3 s on up to 5 s`
std::string text_of(const Window& window) {
  return (window.not_before ? " from " + automata::format_seconds(*window.not_before) + " s on" : "") +
         (window.by ? " up to " + automata::format_seconds(*window.by) + " s" : "");
}

/// What a verdict about a program means.
std::string meaning_of(const ProgramProperty& property, bool violated) {
  switch (property.kind) {
    case Kind::goal_conflict:
      return violated ? "the program can assert contradicting goals in one cycle"
                      : "the program never asserts contradicting goals in one cycle";
    case Kind::no_plan:
      return violated ? "a goal can have no plan" : "every goal has a plan";
    case Kind::endless_wait:
      return violated ? "the program can wait for ever" : "no wait lasts for ever";
    case Kind::termination:
      return violated ? "the program can go on for ever" : "the program ends on every run";
    case Kind::stuck:
      return stuck_text(violated);
    case Kind::undone:
      return violated ? "a reward command can undo an achieved goal"
                      : "no reward command undoes an achieved goal when it is sent";
    case Kind::never:
      return "'" + property.text + "' " + (violated ? "can hold" : "never holds") + text_of(property.window);
    case Kind::response:
      if (property.within.is_infinite()) {
        return "'" + property.then_text + "' " + (violated ? "may never follow" : "always follows") + " '" +
               property.text + "'" + (violated ? "" : " eventually");
      }
      return "'" + property.then_text + "' " + (violated ? "may not follow" : "always follows") + " '" + property.text +
             "' within " + automata::format_seconds(property.within) + " s";
    case Kind::eventually:
      if (property.within.is_infinite()) {
        return "'" + property.text + "' " + (violated ? "may never hold" : "always holds eventually");
      }
      return "'" + property.text + "' " + (violated ? "may not hold" : "always holds at some time") + " within " +
             automata::format_seconds(property.within) + " s";
    case Kind::finally:
      return violated ? "the program can end without '" + property.text + "'"
                      : "'" + property.text + "' holds whenever the program ends";
  }
  return "";
}

/// What it means that a witness of the property was found, or none.
std::string meaning_of(const Property& property, bool found) {
  using std::string;
  return std::visit(
      base::Overloaded{[&](const Reachability&) -> string {
                         return found ? "the target is reachable" : "the target is unreachable";
                       },
                       [&](const Safety&) -> string {
                         return found ? "the forbidden formula can hold" : "the forbidden formula cannot hold";
                       },
                       [&](const Response& r) -> string {
                         if (r.within.is_infinite()) {
                           return found ? "the response may never come" : "the response always comes eventually";
                         }
                         return found ? "the response can come too late or never" : "the response always comes in time";
                       },
                       [&](const Stuck&) -> string { return stuck_text(found); },
                       [&](const ProgramProperty& p) { return meaning_of(p, found); }},
      property);
}

}  // namespace

std::string title(const Subject& subject) {
  return subject.program == nullptr ? subject.plant.name : subject.program->name + " on " + subject.plant.name;
}

std::string_view to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::violated:
      return "violated";
    case Verdict::undecided:
      return "undecided";
  }
  return "";
}

std::string painted(Verdict verdict, bool color, bool warning) {
  const base::Painter painter{color};
  switch (verdict) {
    case Verdict::holds:
      return painter.good(to_text(verdict));
    case Verdict::violated:
      return warning ? painter.doubtful(to_text(verdict)) : painter.bad(to_text(verdict));
    case Verdict::undecided:
      break;
  }
  return painter.doubtful(to_text(verdict));
}

std::string reason(std::optional<Limit> limit, const Progress& p) {
  if (!limit) return "";
  if (p.states == 0 && limit != Limit::plan) return "not begun: " + std::string(limit_text(*limit)) + " before";
  std::string text = std::string(limit_text(*limit)) + " after " + std::to_string(p.states) + " states" +
                     (p.waiting > 0 ? ", " + std::to_string(p.waiting) + " of them unexplored" : "");
  if (p.steps) text += "; all runs of up to " + std::to_string(*p.steps) + " steps were searched";
  if (p.level > 0) text += "; all runs with fewer than " + std::to_string(p.level) + " faults were searched";
  return text;
}

std::string reason(const Answer& answer) {
  if (!answer.limit && answer.cut_off.still)
    return "some runs end in a timelock, and the question has no answer beyond it";
  return reason(answer.limit, answer.progress);
}

std::string vacuity(const Answer& answer) {
  if (answer.startless || !answer.vacuous) return "no initial state is possible";
  switch (*answer.vacuous) {
    case Vacuity::unsatisfiable:
      return "no state satisfies the formula";
    case Vacuity::unimplied:
      return "no state implies the formula";
    case Vacuity::over:
      return "the program has ended before that time on every run";
    case Vacuity::unasked:
      return "the trigger never holds";
    case Vacuity::endless:
      return "the program never ends";
  }
  return "";
}

std::string partly(const Answer& answer) {
  if (answer.witness) return "";
  const bool spent = answer.cut_off.spent;
  if (!answer.cut_off.stuck) {
    return spent ? "runs that exceed the permitted number of faults were checked only up to the excess fault" : "";
  }
  return spent ? "deadlocked runs were checked only up to the deadlock, and runs that exceed the permitted number of "
                 "faults only up to the excess fault"
               : "deadlocked runs were checked only up to the deadlock";
}

std::string notes(const Answer& answer) {
  std::string text = holds_vacuously(answer) ? "vacuous: " + vacuity(answer) + "\n" : "";
  if (const std::string part = partly(answer); !part.empty()) text += "only in part: " + part + "\n";
  for (const std::string& warning : answer.warnings) text += "warning: " + warning + "\n";
  return text;
}

std::string meaning(const Property& property, const Answer& answer) {
  if (answer.verdict == Verdict::undecided) return reason(answer);
  const bool found = answer.witness.has_value();
  const std::string vacuously = holds_vacuously(answer) ? ", because " + vacuity(answer) : "";
  const std::string part = partly(answer);
  return meaning_of(property, found) + vacuously + (part.empty() ? "" : "; " + part);
}

std::string finding(const Subject& subject, const ProgramProperty& property, const Witness& witness) {
  const Cycle& last = *witness.events.back().cycle;
  const auto origin = [&](automata::LocationId id) { return subject.program->locations[id.index()].origin; };
  switch (property.kind) {
    case Kind::goal_conflict: {
      const automata::GoalConflict& conflict = last.conflicts.front();
      return "goals contradict each other: " + to_text(subject.plant.variables, conflict.contradicted) +
             in_brackets(origin(conflict.first)) + " and " + to_text(subject.plant.variables, conflict.asserted) +
             in_brackets(origin(conflict.second));
    }
    case Kind::no_plan:
      return no_plan_text(subject, witness);
    case Kind::termination:
    case Kind::endless_wait:
      if (witness.stop) return to_text(subject.plant, *witness.stop);
      if (witness.repeats_from) return "the loop repeats for ever";
      return waiting_text(subject, witness);
    case Kind::stuck:
      return to_text(subject.plant, *witness.stop);
    case Kind::undone:
      return undone_text(subject, witness);
    case Kind::never:
      return "'" + property.text + "' can hold";
    case Kind::eventually:
      if (witness.stop) return "'" + property.text + "' has not held yet; " + to_text(subject.plant, *witness.stop);
      if (property.within.is_infinite())
        return "'" + property.text + "' never holds: " + endless_text(subject, witness);
      return "'" + property.text + "' did not hold in time";
    case Kind::response:
      return owed_text(subject, Response{property.formula, property.then, property.within}, witness);
    case Kind::finally:
      return "the program has ended, but '" + property.text + "' may be false";
  }
  return "";
}

std::string number_text(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string statistics_text(const Progress& progress) {
  char text[96];
  std::snprintf(text, sizeof text, "%zu states, %.3f s, %.1f MiB\n", progress.states, progress.seconds,
                static_cast<double>(peak_bytes()) / (1024 * 1024));
  return text;
}

}  // namespace rmpl::verifier
