// Events to changes.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/witness_flight.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "automata/assignment_text.hpp"
#include "automata/logic/formula.hpp"
#include "runtime/reasoning/reconfigure/outcome.hpp"
#include "tools/shared/terminal.hpp"
#include "verifier/verdict/report.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::tools {
namespace {

using automata::Ticks;
using runtime::Flight;
using verifier::Answer;
using verifier::Subject;
using verifier::Witness;

/// Between steps of one moment.
constexpr Ticks apart{1};

class Events {
 public:
  Events(const Subject& subject, const Witness& witness, std::optional<Ticks> period)
      : plant_(subject.plant), witness_(witness), period_(period) {
    flight_.plant = &plant_;
    flight_.program = subject.program;
    flight_.cycle = period.value_or(Ticks{});
    flight_.truth.resize(plant_.components.size());
    flight_.commands.resize(plant_.controls.size());
    set_command({}, automata::idle_action(plant_));
  }

  Flight run() {
    const auto& events = witness_.events;
    set_modes({}, events.front().modes);
    Ticks now;
    for (std::size_t e = 1; e < events.size(); ++e) {
      if (witness_.repeats_from == e) note("repeats", now, "from here on the run repeats");
      const Ticks next = std::max(events[e].time, now + apart);
      if (events[e].cycle) {
        cycle(*events[e].cycle, events[e], now);
      } else {
        const Ticks begin =
            period_ ? std::max(now, Ticks{next.count - period_->count}) : Ticks{next.count - apart.count};
        set_command(begin, events[e].action);
        set_command(next, automata::idle_action(plant_));
      }
      set_modes(next, events[e].modes);
      now = next;
    }
    if (events.back().cycle) flight_.marking.set(now, events.back().cycle->next);
    flight_.end = now;
    return std::move(flight_);
  }

 private:
  void note(std::string kind, Ticks at, std::string text) {
    flight_.happenings.push_back({std::move(kind), at, std::nullopt, std::nullopt, std::move(text)});
  }

  void set_modes(Ticks at, const automata::Modes& modes) {
    for (std::size_t c = 0; c < modes.size(); ++c) flight_.truth[c].set(at, modes[c]);
  }

  void set_command(Ticks at, const automata::ControlAction& action) {
    for (std::size_t i = 0; i < action.size(); ++i) flight_.commands[i].set(at, action[i]);
  }

  void cycle(const verifier::Cycle& cycle, const verifier::Event& event, Ticks at) {
    flight_.marking.set(at, cycle.marking);
    std::vector<runtime::AssertedGoal> goals;
    for (std::size_t g = 0; g < cycle.goals.goal.size(); ++g) goals.push_back({cycle.goals.goal[g], cycle.goals.by[g]});
    flight_.goals.set(at, std::move(goals));
    std::vector<runtime::AssertedConstraint> constraints;
    for (const automata::GoalConstraint& constraint : cycle.goals.constraints)
      constraints.push_back({to_text(constraint.formula, plant_.variables), constraint.by});
    flight_.constraints.set(at, std::move(constraints));
    set_command(at, event.action);
    const bool acts = cycle.outcome != runtime::Reconfiguration::Outcome::nothing_to_do;
    const std::string outcome(acts ? runtime::name_of(cycle.outcome) : "");
    flight_.explanations.set(at, {outcome, outcome.empty() ? "" : to_text(cycle.why, plant_, cycle.goals.formula())});
    if (cycle.outcome == runtime::Reconfiguration::Outcome::no_plan) note("no-plan", at, cycle.reason);
    for (const runtime::LeftOut& left_out : cycle.left_out) note("no-plan", at, left_out.reason);
    if (!cycle.conflicts.empty()) note("goal-conflict", at, "goals contradict each other");
  }

  const automata::Plant& plant_;
  const Witness& witness_;
  std::optional<Ticks> period_;
  Flight flight_;
};

std::string fault_name(const Subject& subject, const verifier::FaultOutcome& row) {
  if (!row.fault) return "no fault";
  const automata::Component& component = subject.plant[row.fault->component];
  return component.name + ": " + component.modes[row.fault->from.index()].name + " -> " +
         component.modes[row.fault->to.index()].name;
}

}  // namespace

Flight flight_of(const Subject& subject, const Witness& witness, std::optional<Ticks> period, const Shown& shown) {
  Flight flight = Events(subject, witness, period).run();
  flight.name = shown.name;
  flight.verdict = shown.verdict;
  flight.summary = period ? "steps every " + automata::format_seconds(*period) + " s"
                          : "dense time; simultaneous steps are shown a nanosecond apart";
  const std::string asked_verdict = shown.verdict == "violated" ? "failed" : "met";
  flight.asked.push_back({shown.name, asked_verdict, flight.end, shown.finding, {}});
  return flight;
}

std::vector<Flight> flights_of(const Subject& subject, const std::string& name, const verifier::Property& property,
                               const verifier::CheckOptions& options, const Answer& answer) {
  std::vector<Flight> result;
  if (answer.same_as) return result;
  const auto add = [&](const Witness& witness, const std::string& suffix) {
    std::string found = verifier::end_of(subject, property, witness);
    if (found.empty()) found = verifier::meaning(property, answer);
    result.push_back(flight_of(subject, witness, options.period,
                               {name + suffix, std::string(verifier::to_text(answer.verdict)), std::move(found)}));
  };
  if (answer.witness) add(*answer.witness, "");
  for (std::size_t o = 0; o < answer.others.size(); ++o) add(answer.others[o], ", also " + std::to_string(o + 1));
  for (const verifier::CutSet& cut : answer.cut_sets) {
    std::string faults;
    for (const verifier::Fault& fault : cut.faults) {
      faults += (faults.empty() ? "" : ", ") + to_text(subject.plant[fault.component], fault.mode);
    }
    add(cut.witness, ", cut set " + (faults.empty() ? "of none" : faults));
  }
  return result;
}

std::vector<Flight> flights_of(const Subject& subject, const verifier::FaultTable& table, std::optional<Ticks> period) {
  std::vector<Flight> result;
  for (const verifier::FaultOutcome& row : table.rows) {
    const auto add = [&](const std::optional<Witness>& witness, const std::string& what, bool bad) {
      if (!witness) return;
      result.push_back(flight_of(subject, *witness, period,
                                 {fault_name(subject, row) + ", " + what, bad ? "violated" : "holds", what}));
    };
    add(row.lost, "the mission is lost", true);
    add(row.waits, "the program waits for ever", true);
    add(row.goes_on, "the program goes on for ever", true);
    add(row.stops, "nothing can follow", true);
    add(row.success, "success", false);
  }
  return result;
}

TraceReport::TraceReport(const std::string& path, const Subject& subject) {
  if (!path.empty()) file_.emplace(path, std::vector<ReportFile::Subject>{{&subject.plant, subject.program}});
}

void TraceReport::write(std::vector<Flight> flights, const Subject& subject, bool quiet) {
  if (!file_) return;
  if (flights.empty() && !quiet) tell("no trace was found, so no report is written");
  for (Flight& flight : flights) flight.program = subject.program;
  file_->write(verifier::title(subject), std::move(flights), quiet);
}

}  // namespace rmpl::tools
