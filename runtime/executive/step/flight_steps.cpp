// Cycles in two parts: what is decided, and what comes of it.
// SPDX-License-Identifier: MIT
#include "runtime/executive/step/flight_steps.hpp"

#include <algorithm>
#include <utility>

#include "automata/assignment_text.hpp"
#include "base/error.hpp"
#include "base/overloaded.hpp"
#include "runtime/executive/trace/evidence_line.hpp"
#include "runtime/reasoning/reconfigure/reason.hpp"

namespace rmpl::runtime {
namespace {

using automata::Ticks;

constexpr std::size_t believed_at_most = 5;

automata::Scenario with_choices(automata::Scenario scenario, const std::vector<Choice>& choices) {
  for (const Choice& choice : choices) {
    std::visit(
        base::Overloaded{[&](const automata::ForcedMode& forced) { scenario.forced.push_back(forced); },
                         [&](const automata::GivenCommand& given) { scenario.commands.push_back(given); },
                         [&](const automata::SensorOverride& dictated) { scenario.overrides.push_back(dictated); }},
        choice.event);
  }
  return scenario;
}

/// The modes in which a state differs from the most likely one.
std::string differences(const automata::Plant& plant, const automata::Modes& modes, const automata::Modes& best) {
  std::string text;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (modes[c] == best[c]) continue;
    text += (text.empty() ? "" : ", ") + to_text(plant.components[c], modes[c]);
  }
  return text;
}

/// The most likely combinations of modes, whatever their clocks; the first is the estimate.
std::vector<Stop::Believed> believed(const CycleRecord& record, const automata::Plant& plant) {
  const automata::Modes& estimate = record.estimate;
  std::vector<std::pair<automata::Modes, double>> sums;
  for (const BeliefEntry& entry : record.estimator->belief()) {
    const automata::Modes& modes = entry.state.modes;
    const auto known = std::find_if(sums.begin(), sums.end(), [&](const auto& sum) { return sum.first == modes; });
    if (known != sums.end()) {
      known->second += entry.probability;
    } else {
      sums.emplace_back(modes, entry.probability);
    }
  }
  std::stable_sort(sums.begin(), sums.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  const auto best = std::find_if(sums.begin(), sums.end(), [&](const auto& sum) { return sum.first == estimate; });
  std::vector<Stop::Believed> result{{best == sums.end() ? record.probability : best->second,
                                      to_text(plant.variables, automata::assignments_of(plant, estimate))}};
  for (const auto& [modes, probability] : sums) {
    if (result.size() == believed_at_most) break;
    if (modes == estimate || probability < 1e-9) continue;
    result.push_back({probability, differences(plant, modes, estimate)});
  }
  return result;
}

}  // namespace

FlightSteps::FlightSteps(const automata::Document& document, automata::Scenario scenario, ScenarioOptions options,
                         std::vector<Choice> choices)
    : document_(document),
      base_(std::move(scenario)),
      options_(std::move(options)),
      choices_(std::move(choices)),
      step_(document.plant_of(base_)) {
  if (!options_.graph) options_.graph = reconfiguration_graph(document.plant_of(base_));
  assemble();
}

void FlightSteps::assemble() {
  scenario_ = with_choices(base_, choices_);
  flight_ = std::make_unique<ScenarioFlight>(document_, scenario_, options_);
  story_ = std::make_unique<Story>(plant(), program(), MomentColumn(base_.duration, base_.cycle), base::Painter{},
                                   StoryFocus{}, [this](const std::string& line) { lines_.push_back(line); });
  lines_.clear();
  done_ = 0;
  diagnosed_.assign(plant().components.size(), std::nullopt);
  truth_.clear();
  estimate_.clear();
  look_at(flight_->executive().record());
  begin();
}

void FlightSteps::look_at(const CycleRecord& record) {
  time_ = record.time;
  ended_ = flight_->executive().ended();
  last_ = record;
  if (record.truth != nullptr) go_on(truth_, truth_since_, *record.truth);
  go_on(estimate_, estimate_since_, record.estimate);
  for (std::size_t c = 0; c < diagnosed_.size(); ++c) {
    if (!plant().components[c].modes[estimate_[c].index()].fault) diagnosed_[c].reset();
  }
  for (const Evidence& evidence : record.evidence) {
    diagnosed_[evidence.component.index()] = to_text(evidence, record.estimate, plant());
  }
  story_->observe(record);
}

/// To the modes at the end of a cycle, with when their clocks began.
void FlightSteps::go_on(automata::Modes& modes, std::vector<Ticks>& since, automata::Modes now) {
  if (modes.empty()) {
    since.assign(now.size(), time_);
  } else {
    since = step_.advance({std::move(modes), std::move(since)}, last_.command, now, time_).clock_starts;
  }
  modes = std::move(now);
}

/// The first half of the next cycle, unless the run is over.
void FlightSteps::begin() {
  if (time_ < base_.duration) flight_->executive().decide();
}

/// Its second half.
const CycleRecord& FlightSteps::carry_out() {
  const CycleRecord& record = flight_->executive().carry_out();
  ++done_;
  look_at(record);
  return record;
}

bool FlightSteps::advance(const Look& look) {
  if (time_ >= base_.duration) return false;
  const std::uint64_t stood = done_;
  try {
    const CycleRecord& record = carry_out();
    if (look) look(record, ended_);
    begin();
  } catch (...) {
    // The cycle can neither be taken back nor gone on with.
    go_back_to(stood);
    throw;
  }
  return true;
}

void FlightSteps::fly_again_to(std::uint64_t position) {
  assemble();
  while (done_ < position) {
    if (options_.interrupted()) throw Interrupted();
    carry_out();
    begin();
  }
  lines_.clear();
}

void FlightSteps::go_back_to(std::uint64_t position) {
  std::erase_if(choices_, [&](const Choice& choice) { return choice.cycle >= position; });
  fly_again_to(position);
}

void FlightSteps::choose(Choice choice) {
  choices_.push_back(std::move(choice));
  fly_again_to(done_);
}

void FlightSteps::force(automata::ComponentId component, automata::ModeId mode) {
  const automata::Component& forced = plant()[component];
  if (forced.software && forced.modes[mode.index()].fault) {
    // A mode of software comes by a draw, or later than asked for.
    const auto& moves = step_.moves({truth_, truth_since_}, flight_->executive().record().command, time_, next_time());
    const auto& open = moves[component.index()];
    if (std::none_of(open.begin(), open.end(), [&](const automata::Move& move) { return move.mode == mode; })) {
      throw base::InputError("fault: no draw of '" + forced.name + "' leads to '" + forced.modes[mode.index()].name +
                             "' in this cycle");
    }
  }
  choose({done_, automata::ForcedMode{next_time(), component, mode, {}}});
}

void FlightSteps::command(automata::Assignment command) {
  choose({done_, automata::GivenCommand{time_, base_.cycle, command, {}}});
}

void FlightSteps::observe(automata::Assignment reading, Ticks duration) {
  choose({done_, automata::SensorOverride{next_time(), duration, reading, {}}});
}

std::vector<Prospect> FlightSteps::ahead() {
  if (time_ >= base_.duration) return {};
  const automata::ControlAction& action = flight_->executive().record().command;
  const bool true_modes = has_truth();
  const automata::SystemState state{true_modes ? truth_ : estimate_, true_modes ? truth_since_ : estimate_since_};
  return prospects(step_, state, action, time_, next_time());
}

Stop FlightSteps::stop() {
  const CycleRecord& record = flight_->executive().record();
  Stop stop;
  stop.cycle = done_;
  stop.time = time_;
  stop.ended = ended_;
  if (has_truth()) stop.truth = facts_of(plant(), truth_, truth_since_);
  stop.estimate = facts_of(plant(), estimate_, has_truth() ? std::vector<Ticks>{} : estimate_since_);
  stop.believes_truth = has_truth() && truth_ == estimate_;
  stop.belief = believed(record, plant());
  stop.readings = facts_of(plant(), record.observations);
  for (const Event& event : last_.events) {
    if (event.kind == Event::Kind::inconsistent || event.kind == Event::Kind::cut) {
      stop.told.push_back((event.kind == Event::Kind::inconsistent ? "surprise: " : "") + event.message);
    }
  }
  for (std::size_t c = 0; c < diagnosed_.size(); ++c) {
    const automata::Component& component = plant().components[c];
    if (!component.modes[estimate_[c].index()].fault) continue;
    stop.faults.push_back(to_text(component, estimate_[c]) + (diagnosed_[c] ? ": " + *diagnosed_[c] : ""));
  }
  stop.over = time_ >= base_.duration;
  if (stop.over) return stop;
  for (const automata::LocationId id : record.marking) {
    const automata::Location& location = program().locations[id.index()];
    if (!location.composite) stop.marking.push_back({location.label, location.origin});
  }
  const automata::Goals& goals = record.goals;
  for (std::size_t i = 0; i < goals.goal.size(); ++i) {
    stop.goals.push_back({to_text(plant().variables, goals.goal[i]), program().locations[goals.by[i].index()].origin});
  }
  for (const automata::GoalConstraint& constraint : goals.constraints) {
    stop.goals.push_back(
        {to_text(constraint.formula, plant().variables), program().locations[constraint.by.index()].origin});
  }
  stop.command = to_text(plant().variables, automata::commanded(plant(), record.command));
  stop.why =
      record.outcome == Reconfiguration::Outcome::nothing_to_do ? "" : to_text(record.why, plant(), goals.formula());
  // What has been decided for the cycle that begins tells its events too.
  for (const Event& event : record.events) {
    switch (event.kind) {
      case Event::Kind::goal_conflict:
      case Event::Kind::commanded:
      case Event::Kind::irreversible:
        stop.told.push_back(event.message);
        break;
      case Event::Kind::no_plan: {
        const std::string way_out = remedy(record.why, plant());
        stop.told.push_back("no plan: " + event.message + (way_out.empty() ? "" : "; " + way_out));
        break;
      }
      case Event::Kind::inconsistent:
      case Event::Kind::cut:
      case Event::Kind::forced:
      case Event::Kind::connected:
      case Event::Kind::gone:
      case Event::Kind::refused:
      case Event::Kind::late:
      case Event::Kind::flood:
      case Event::Kind::unacknowledged:
        break;  // of the cycle that has ended, or of a live plant
    }
  }
  return stop;
}

std::string FlightSteps::cannot_answer(const automata::Formula&) const { return {}; }

std::vector<std::string> FlightSteps::take_story() { return std::exchange(lines_, {}); }

}  // namespace rmpl::runtime
