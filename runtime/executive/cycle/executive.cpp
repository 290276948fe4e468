// The fifteen steps of one cycle (thesis 7.1.1).
// SPDX-License-Identifier: MIT
#include "runtime/executive/cycle/executive.hpp"

#include <string>

#include "automata/assignment_text.hpp"
#include "automata/time/checked_ticks.hpp"
#include "base/error.hpp"
#include "runtime/executive/cycle/stopwatch.hpp"
#include "runtime/executive/sequence/goal_conflict.hpp"
#include "runtime/executive/trace/surprise.hpp"
#include "runtime/reasoning/estimate/set_aside.hpp"

namespace rmpl::runtime {

Executive::Executive(const automata::Program& program, const automata::Plant& model, Estimator& estimator,
                     Reconfigurer& reconfigurer, PlantInterface& plant, Clock& clock, automata::Ticks cycle)
    : model_(model),
      program_(program),
      plant_(plant),
      clock_(clock),
      cycle_(cycle),
      estimator_(estimator),
      sequencer_(program, model),
      control_(plant, to_estimation_),
      monitor_(plant, to_estimation_),
      reconfiguration_(model, reconfigurer, clock, to_reconfiguration_, control_),
      estimation_(model, estimator, clock, to_estimation_, to_reconfiguration_),
      explainer_(model),
      insight_(model, sequencer_.asked()) {
  record_.marking = sequencer_.marking();
  record_.command = automata::idle_action(model);
  read_back({});
  plant_.overhear(record_.estimate, record_.time);
}

automata::Ticks Executive::end_of(std::uint64_t cycle) const {
  if (const auto end = automata::checked_product(cycle_, cycle)) return *end;
  throw base::InputError("time ends " + automata::format_seconds({automata::Ticks::infinite().count - 1}) +
                         " s after the start, and cycle " + std::to_string(cycle) + " of " +
                         automata::format_seconds(cycle_) + " s would end later; expected a shorter duration");
}

template <class Work>
double Executive::timed(const Work& work) const {
  if (!measured_) {
    work();
    return 0;
  }
  const Stopwatch stopwatch;
  work();
  return stopwatch.seconds();
}

const CycleRecord& Executive::run_cycle() {
  decide();
  return carry_out();
}

const CycleRecord& Executive::decide() {
  ++record_.cycle;
  record_.events.clear();
  record_.marking = sequencer_.marking();
  assert_goals();                                                                    // 1 to 3
  record_.reconfiguration_seconds = timed([this] { reconfiguration_.dispatch(); });  // 4 to 8: MR's command is issued,
                                                                                     // and ME is told
  note_reconfiguration();
  return record_;
}

const CycleRecord& Executive::carry_out() {
  clock_.wait_until(end_of(record_.cycle));
  const automata::Observation& observations = monitor_.sample(clock_.now());  // 9
  control_.request_estimate();                                                // 10
  record_.estimation_seconds = timed([this] { estimation_.dispatch(); });     // 11 to 15
  read_back(observations);
  sequencer_.finish(knowledge_);
  plant_.overhear(record_.estimate, record_.time);
  return record_;
}

void Executive::assert_goals() {
  // 1. The sequencer queries the clock, checks maintenance constraints and establishes the goals.
  record_.start = clock_.now();
  const automata::Asserted& asserted = sequencer_.begin(knowledge_, record_.start);
  asserted_.clear();
  for (const automata::GoalConflict& conflict : asserted.conflicts) {
    record_.events.push_back(describe(conflict, program_, model_.variables));
  }
  // Goals that contradict each other are not acted on (semantics 2): MR is asked with none, and stays idle.
  if (asserted.conflicts.empty()) asserted_ = goals_of(asserted);
  // 2. It pushes the goals, 3. and then the request.
  for (const automata::Goals& goals : asserted_) to_reconfiguration_.push(GoalAsserted{&goals});
  to_reconfiguration_.push(ReconfigurationRequested{});
}

void Executive::note_reconfiguration() {
  const Pursued& pursued = reconfiguration_.pursued();
  const Reconfiguration& answer = pursued.answer;
  record_.goals = pursued.goals;
  record_.left_out = pursued.left_out;
  record_.command = reconfiguration_.issued();
  record_.considered = reconfiguration_.checked();
  record_.outcome = answer.outcome;
  record_.why = answer.why;
  switch (answer.outcome) {
    case Reconfiguration::Outcome::no_plan:
      record_.events.push_back({Event::Kind::no_plan, answer.reason, answer.component, std::nullopt});
      break;
    case Reconfiguration::Outcome::command:
      if (answer.irreversible) {
        record_.events.push_back(
            {Event::Kind::irreversible, "the command is irreversible", answer.component, std::nullopt});
      }
      break;
    case Reconfiguration::Outcome::wait:
    case Reconfiguration::Outcome::nothing_to_do:
      break;
  }
  if (record_.command != answer.action) note_commanded(answer);
  for (const LeftOut& left_out : pursued.left_out) {
    record_.events.push_back({Event::Kind::no_plan, left_out.reason, left_out.component, std::nullopt});
  }
}

/// What the scenario commands has no reason that the executive knows.
void Executive::note_commanded(const Reconfiguration& answer) {
  const auto told = [&](const automata::ControlAction& action) {
    const std::string text = to_text(model_.variables, automata::commanded(model_, action));
    return text.empty() ? std::string("nothing") : text;
  };
  record_.events.push_back({Event::Kind::commanded,
                            told(record_.command) + " is commanded instead of " + told(answer.action), std::nullopt,
                            std::nullopt});
  if (record_.outcome == Reconfiguration::Outcome::no_plan) return;
  record_.outcome = automata::commanded(model_, record_.command).empty() ? Reconfiguration::Outcome::nothing_to_do
                                                                         : Reconfiguration::Outcome::command;
  record_.why = {};
}

void Executive::read_back(const automata::Observation& observations) {
  const Estimate& estimate = estimation_.estimate();
  // Readings that contradict the estimate would make every constraint entailed: they explain nothing, and are not
  // handed on.
  const automata::Observation counted = without(observations, estimate.set_aside);
  record_.time = estimation_.time();
  record_.observations = observations;
  const auto samples = plant_.samples();
  record_.samples.assign(samples.begin(), samples.end());
  if (const Monitors* monitors = plant_.monitors()) {
    record_.channels = &monitors->channels();
    record_.monitors = &monitors->monitors();
  }
  record_.set_aside = estimate.set_aside;
  record_.evidence = explainer_.evidence_of_new(record_.estimate, estimator_, counted);
  record_.estimate = estimate.modes;
  record_.probability = estimate.probability;
  record_.consistent = estimate.consistent;
  record_.checked = estimate.checked;
  record_.estimator = &estimator_;
  record_.truth = plant_.truth();
  const auto& happenings = plant_.happenings();
  record_.events.insert(record_.events.end(), happenings.begin(), happenings.end());
  if (auto surprise = surprise_of(estimate, model_.variables)) record_.events.push_back(*std::move(surprise));
  if (estimate.cut) {
    record_.events.push_back(
        {Event::Kind::cut, "the search ended early; the belief may lack states", std::nullopt, std::nullopt});
  }
  knowledge_.assignments.clear();
  automata::append_known(model_, estimate.modes, knowledge_.assignments);
  knowledge_.assignments.insert(knowledge_.assignments.end(), counted.begin(), counted.end());
  know_itself(counted);
}

/// What the conditions ask of the executive, as of this cycle.
void Executive::know_itself(const automata::Observation& counted) {
  const std::vector<automata::Formula>& asked = sequencer_.asked();
  if (asked.empty()) return;
  knowledge_.answers.clear();
  record_.known.clear();
  for (const automata::Formula& atom : asked) {
    const bool so = atom.knowing == automata::Knowing::no_plan
                        ? no_plan(record_.goals, record_.outcome, record_.left_out, about(model_, atom), model_)
                        : insight_.answer(atom, estimator_, counted);
    knowledge_.answers.push_back(so);
    if (so) record_.known.push_back(to_text(atom, model_.variables));
  }
}

}  // namespace rmpl::runtime
