// Why a program is held up, in words.
// SPDX-License-Identifier: MIT
#include "verifier/verdict/cause.hpp"

#include <algorithm>

#include "automata/assignment_text.hpp"
#include "automata/time/checked_ticks.hpp"
#include "verifier/verdict/trace.hpp"
#include "verifier/witness/hindrance.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::Formula;
using automata::LocationId;

namespace {

/// So many components are named where a wait is explained.
constexpr std::size_t most_hindrances = 3;

/// ` (main.rmpl:3:5)`: the marked location that asserts a conjunct of a goal.
std::string place_of(const Subject& subject, const automata::Marking& marking, const Formula& conjunct) {
  for (const LocationId id : marking) {
    const automata::Location& location = subject.program->locations[id.index()];
    if (!location.has_goal()) continue;
    const std::vector<Formula> own = conjuncts_of(goal_of(location));
    if (std::find(own.begin(), own.end(), conjunct) != own.end()) return in_brackets(location.origin);
  }
  return "";
}

/// What bars the way, where, and what would permit a plan.
std::string barrier_text(const Subject& subject, const runtime::Reason& why, const std::string& reason) {
  const std::string way_out = remedy(why, subject.plant);
  return reason + in_brackets(origin_of(subject.plant, why)) + (way_out.empty() ? "" : "; " + way_out);
}

}  // namespace

std::string no_plan_text(const Subject& subject, const Witness& witness) {
  const Cycle& cycle = *witness.events.back().cycle;
  const automata::Variables& variables = subject.plant.variables;
  const auto asked = [&](const Formula& goal) {
    return to_text(goal, variables) + place_of(subject, cycle.marking, conjuncts_of(goal).front()) + ": ";
  };
  std::string text;
  if (cycle.outcome == runtime::Reconfiguration::Outcome::no_plan) {
    const std::vector<Formula> goal = conjuncts_of(cycle.goals.formula());
    const std::size_t conjunct = cycle.why.conjunct.value_or(0);
    const bool one = conjunct < goal.size() && (cycle.why.conjunct || goal.size() == 1) && !cycle.goals.empty();
    text = "no plan" + (one ? " for " + asked(goal[conjunct]) : ": ") + barrier_text(subject, cycle.why, cycle.reason);
  }
  for (const Refusal& other : witness.refused) {
    text += (text.empty() ? "no plan for " : "; nor for ") + asked(other.goal) +
            barrier_text(subject, other.why, other.reason);
  }
  return text;
}

std::string waiting_text(const Subject& subject, const Witness& witness) {
  const Cycle& last = *witness.events.back().cycle;
  std::string text = "from here on only a fault can change the state; the program ";
  text += last.marking.empty() ? "has ended" : "waits";
  bool first = true;
  for (const LocationId id : last.marking) {
    const automata::Location& location = subject.program->locations[id.index()];
    if (location.composite) continue;
    text += std::string(first ? " at `" : ", `") + location.label + "`" + in_brackets(location.origin);
    first = false;
  }
  if (!last.conflicts.empty()) return text + ": its goals contradict each other, so the executive sends no command";
  if (lacks_a_plan(last)) return text + ": " + no_plan_text(subject, witness);
  for (std::size_t h = 0; h < witness.hindrances.size() && h < most_hindrances; ++h) {
    text += (h == 0 ? ": " : "; ") + to_text(subject.plant, witness.hindrances[h]);
  }
  return text;
}

std::string endless_text(const Subject& subject, const Witness& witness) {
  if (witness.waits_for_ever) return waiting_text(subject, witness);
  const std::vector<Event>& events = witness.events;
  const bool rests = witness.repeats_from && !events.back().cycle && *witness.repeats_from + 1 == events.size() &&
                     events[events.size() - 2].modes == events.back().modes;
  return rests ? "from here on the state need not change" : "this repeats for ever";
}

std::string undone_text(const Subject& subject, const Witness& witness) {
  const Undone& undone = *witness.undone;
  const Assignment lost{subject.plant[undone.component].mode, automata::ValueId(undone.mode.index())};
  const Event& event = witness.events[witness.events.size() - 2];
  return "`" + to_text(subject.plant.variables, lost) + "`" +
         place_of(subject, witness.events[undone.asked].cycle->marking, automata::is(lost.variable, lost.value)) +
         " is undone, but no goal asks for that: the command is " +
         to_text(event.cycle->why, subject.plant, event.cycle->goals.formula()) +
         "; to keep it, assert the goal for longer";
}

std::string owed_text(const Subject& subject, const Response& response, const Witness& witness) {
  const automata::Ticks since = witness.events[*witness.owed_since].time;
  const std::string owed = "'" + to_text(response.then, subject.plant.variables) + "' is due since " +
                           automata::format_seconds(since) + " s, but ";
  const std::string stop = witness.stop ? to_text(subject.plant, *witness.stop) : "";
  if (response.within.is_infinite()) {
    return owed + "never comes: " + (stop.empty() ? endless_text(subject, witness) : stop);
  }
  const auto deadline = automata::checked_sum(since, response.within).value_or(automata::Ticks::infinite());
  return owed + "did not hold by " + automata::format_seconds(deadline) + " s" + (stop.empty() ? "" : "; " + stop);
}

}  // namespace rmpl::verifier
