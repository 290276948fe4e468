// Why a program is held up, in words.
// SPDX-License-Identifier: MIT
#include "verifier/verdict/cause.hpp"

#include <algorithm>

#include "automata/assignment_text.hpp"
#include "verifier/verdict/trace.hpp"
#include "verifier/witness/hindrance.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::LocationId;

namespace {

/// So many components are named where a wait is explained.
constexpr std::size_t most_hindrances = 3;

/// ` (main.rmpl:3:5)`: the marked location that asserts a goal.
std::string place_of(const Subject& subject, const automata::Marking& marking, const Assignment& goal) {
  for (const LocationId id : marking) {
    const automata::Location& location = subject.program->locations[id.index()];
    const bool asserts = std::find(location.goal.begin(), location.goal.end(), goal) != location.goal.end();
    if (asserts) return in_brackets(location.origin);
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
  std::string goal;
  const std::size_t conjunct = cycle.why.conjunct.value_or(0);
  if (conjunct < cycle.goal.size() && (cycle.why.conjunct || cycle.goal.size() == 1)) {
    const Assignment& asked = cycle.goal[conjunct];
    goal = "for " + to_text(subject.plant.variables, asked) + place_of(subject, cycle.marking, asked) + ": ";
  }
  std::string text = "no plan" + (goal.empty() ? ": " : " " + goal) + barrier_text(subject, cycle.why, cycle.reason);
  for (const Refusal& other : witness.refused) {
    text += "; nor for " + to_text(subject.plant.variables, other.goal) + place_of(subject, cycle.marking, other.goal) +
            ": " + barrier_text(subject, other.why, other.reason);
  }
  return text;
}

std::string waiting_text(const Subject& subject, const Witness& witness) {
  const Cycle& last = *witness.events.back().cycle;
  std::string text = "nothing but a fault would change anything any more; the program waits";
  bool first = true;
  for (const LocationId id : last.marking) {
    const automata::Location& location = subject.program->locations[id.index()];
    if (location.composite) continue;
    text += std::string(first ? " at `" : ", `") + location.label + "`" + in_brackets(location.origin);
    first = false;
  }
  if (!last.conflicts.empty()) return text + ": goals that contradict each other are not acted on";
  if (last.outcome == runtime::Reconfiguration::Outcome::no_plan) return text + ": " + no_plan_text(subject, witness);
  for (std::size_t h = 0; h < witness.hindrances.size() && h < most_hindrances; ++h) {
    text += (h == 0 ? ": " : "; ") + to_text(subject.plant, witness.hindrances[h]);
  }
  return text;
}

std::string undone_text(const Subject& subject, const Witness& witness) {
  const Undone& undone = *witness.undone;
  const Assignment lost{subject.plant[undone.component].mode, automata::ValueId(undone.mode.index())};
  const Event& event = witness.events[witness.events.size() - 2];
  return "`" + to_text(subject.plant.variables, lost) + "`" +
         place_of(subject, witness.events[undone.asked].cycle->marking, lost) +
         " is undone, and no goal asks for that: the command is " +
         to_text(event.cycle->why, subject.plant, automata::conjunction_of(event.cycle->goal)) +
         "; a goal that goes on asking for it would keep it";
}

std::string owed_text(const Subject& subject, const Response& response, const Witness& witness) {
  const automata::Ticks since = witness.events[*witness.owed_since].time;
  return "'" + to_text(response.then, subject.plant.variables) + "' is owed since " + automata::format_seconds(since) +
         " s, and was to come by " + automata::format_seconds(since + response.within) + " s" +
         (witness.stop ? "; " + to_text(subject.plant, *witness.stop) : "");
}

}  // namespace rmpl::verifier
