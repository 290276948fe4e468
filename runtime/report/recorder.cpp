// Cycles to changes.
// SPDX-License-Identifier: MIT
#include "runtime/report/recorder.hpp"

#include <algorithm>
#include <cmath>

#include "automata/assignment_text.hpp"
#include "automata/place.hpp"
#include "runtime/executive/scenario/moment.hpp"
#include "runtime/executive/trace/evidence_line.hpp"
#include "runtime/executive/trace/forced.hpp"
#include "runtime/reasoning/reconfigure/outcome.hpp"

namespace rmpl::runtime {
namespace {

/// From this share on every mode of the estimate has a share that is shown as all.
constexpr double as_good_as_all = 0.995;

FlownChannel flown_channel(const std::string& name, const std::vector<automata::Monitor>* monitors) {
  FlownChannel channel{name, {}};
  if (monitors == nullptr) return channel;
  for (const automata::Monitor& monitor : *monitors) {
    if (monitor.channel != name && monitor.minus != name) continue;
    channel.attributes.push_back(monitor.attribute);
    if (monitor.minus || monitor.over) continue;
    for (const automata::Band& band : monitor.bands) channel.limits.emplace_back(monitor.attribute, band);
  }
  return channel;
}

}  // namespace

Recorder::Recorder(const automata::Document& document, const automata::Scenario& scenario)
    : scenario_(scenario), plant_(document.plant_of(scenario)) {
  flight_.name = scenario.name;
  flight_.plant = &plant_;
  flight_.program = &document.programs[scenario.program];
  flight_.cycle = scenario.cycle;
  flight_.estimate.resize(plant_.components.size());
  flight_.belief.resize(plant_.components.size());
  flight_.commands.resize(plant_.controls.size());
  flight_.readings.resize(plant_.observables.size());
  command_ = automata::idle_action(plant_);
  for (std::size_t i = 0; i < command_.size(); ++i) flight_.commands[i].set({}, command_[i]);
  for (auto& reading : flight_.readings) reading.set({}, std::nullopt);
}

void Recorder::observe(const CycleRecord& record) {
  note_action(record);
  note_samples(record);
  note_state(record);
  note_belief(record);
  note_events(record);
}

void Recorder::note_action(const CycleRecord& record) {
  if (record.cycle == 0) {
    marking_ = record.marking;
    flight_.marking.set({}, marking_);
    return;
  }
  const bool same_goal = record.goals == goals_;
  if (record.marking != marking_) flight_.marking.set(record.start, marking_ = record.marking);
  if (!same_goal) {
    goals_ = record.goals;
    std::vector<AssertedGoal> goals;
    for (std::size_t i = 0; i < goals_.goal.size(); ++i) goals.push_back({goals_.goal[i], goals_.by[i]});
    flight_.goals.set(record.start, std::move(goals));
    std::vector<AssertedConstraint> constraints;
    for (const automata::GoalConstraint& constraint : goals_.constraints)
      constraints.push_back({to_text(constraint.formula, plant_.variables), constraint.by});
    flight_.constraints.set(record.start, std::move(constraints));
  }
  if (record.command != command_) {
    command_ = record.command;
    for (std::size_t i = 0; i < command_.size(); ++i) flight_.commands[i].set(record.start, command_[i]);
  }
  if (!same_goal || record.outcome != outcome_ || record.why != why_) {
    outcome_ = record.outcome;
    why_ = record.why;
    const bool acts = outcome_ != Reconfiguration::Outcome::nothing_to_do;
    const std::string outcome(acts ? runtime::name_of(outcome_) : "");
    flight_.explanations.set(record.start,
                             {outcome, outcome.empty() ? "" : to_text(why_, plant_, record.goals.formula())});
  }
}

void Recorder::note_samples(const CycleRecord& record) {
  for (const Sample& sample : record.samples) {
    const std::string& name = (*record.channels)[sample.channel];
    auto& all = flight_.channels;
    auto at = std::lower_bound(all.begin(), all.end(), name,
                               [](const FlownChannel& channel, const std::string& one) { return channel.name < one; });
    if (at == all.end() || at->name != name) at = all.insert(at, flown_channel(name, record.monitors));
    const bool finite = sample.number && std::isfinite(*sample.number);
    at->signal.set(record.time, finite ? Signal{sample.number, {}} : Signal{std::nullopt, sample.text});
  }
}

void Recorder::note_state(const CycleRecord& record) {
  if (record.observations != observations_) {
    observations_ = record.observations;
    for (std::size_t i = 0; i < plant_.observables.size(); ++i) {
      const auto seen = std::find_if(observations_.begin(), observations_.end(), [&](const automata::Assignment& a) {
        return a.variable == plant_.observables[i];
      });
      flight_.readings[i].set(record.time, seen == observations_.end() ? std::nullopt : std::optional(seen->value));
    }
  }
  std::string set_aside = to_text(plant_.variables, record.set_aside);
  if (set_aside != set_aside_) flight_.set_aside.set(record.time, set_aside_ = std::move(set_aside));
  if (record.estimate != estimate_) {
    estimate_ = record.estimate;
    for (std::size_t c = 0; c < flight_.estimate.size(); ++c) flight_.estimate[c].set(record.time, estimate_[c]);
  }
  if (record.truth != nullptr && *record.truth != truth_) {
    truth_ = *record.truth;
    flight_.truth.resize(plant_.components.size());
    for (std::size_t c = 0; c < flight_.truth.size(); ++c) flight_.truth[c].set(record.time, truth_[c]);
  }
}

void Recorder::note_belief(const CycleRecord& record) {
  if (record.probability >= as_good_as_all) {
    if (!certain_) {
      for (auto& belief : flight_.belief) belief.set(record.time, {});
    }
    certain_ = true;
    return;
  }
  certain_ = false;
  const Belief& belief = record.estimator->belief();
  double sum = 0;
  for (const BeliefEntry& entry : belief) sum += entry.probability;
  if (!(sum > 0)) return;
  std::vector<double> share;
  for (std::size_t c = 0; c < plant_.components.size(); ++c) {
    share.assign(plant_.components[c].modes.size(), 0);
    for (const BeliefEntry& entry : belief) share[entry.state.modes[c].index()] += entry.probability / sum;
    Shares shares;
    for (std::size_t m = 0; m < share.size(); ++m) {
      const auto percent = static_cast<unsigned>(std::lround(100 * share[m]));
      if (percent > 0) shares.emplace_back(automata::ModeId(m), percent);
    }
    const bool sure = shares.size() == 1 && shares.front().first == record.estimate[c];
    flight_.belief[c].set(record.time, sure ? Shares{} : std::move(shares));
  }
}

void Recorder::note_events(const CycleRecord& record) {
  for (const Evidence& evidence : record.evidence) {
    const automata::Component& component = plant_[evidence.component];
    flight_.happenings.push_back(
        {"fault", record.time, std::nullopt, evidence.component,
         to_text(component, evidence.fault) + ": " + to_text(evidence, record.estimate, plant_)});
  }
  for (auto& [event, happening] : open_) {
    if (std::find(record.events.begin(), record.events.end(), event) != record.events.end()) continue;
    flight_.happenings[happening].to = record.start;
  }
  std::erase_if(open_, [&](const auto& open) { return flight_.happenings[open.second].to.has_value(); });
  for (const Event& event : record.events) {
    const auto known = std::find_if(open_.begin(), open_.end(), [&](const auto& open) { return open.first == event; });
    if (known != open_.end()) continue;
    const bool at_start = event.kind == Event::Kind::no_plan || event.kind == Event::Kind::goal_conflict ||
                          event.kind == Event::Kind::irreversible || event.kind == Event::Kind::commanded;
    std::string text = event.message;
    if (event.kind == Event::Kind::no_plan) {
      if (const std::string way_out = remedy(record.why, plant_); !way_out.empty()) text += "; " + way_out;
    }
    open_.emplace_back(event, flight_.happenings.size());
    flight_.happenings.push_back({std::string(runtime::name_of(event.kind)), at_start ? record.start : record.time,
                                  std::nullopt, event.component, std::move(text),
                                  is_forced_as_nominal(event, record, plant_)});
  }
}

void Recorder::forget() {
  const auto forget_all = [](auto& tracks) {
    for (auto& track : tracks) track.forget();
  };
  forget_all(flight_.truth);
  forget_all(flight_.estimate);
  forget_all(flight_.belief);
  forget_all(flight_.commands);
  forget_all(flight_.readings);
  for (FlownChannel& channel : flight_.channels) channel.signal.forget();
  flight_.marking.forget();
  flight_.goals.forget();
  flight_.constraints.forget();
  flight_.set_aside.forget();
  flight_.explanations.forget();
  std::vector<Happening> left;
  for (auto& [event, happening] : open_) {
    left.push_back(std::move(flight_.happenings[happening]));
    happening = left.size() - 1;
  }
  flight_.happenings = std::move(left);
}

Flight Recorder::finish(const ScenarioResult& result) {
  for (auto& [event, happening] : open_) flight_.happenings[happening].to = result.time;
  std::stable_sort(flight_.happenings.begin(), flight_.happenings.end(),
                   [](const Happening& a, const Happening& b) { return a.from < b.from; });
  if (result.ended) flight_.marking.set(*result.ended, {});
  flight_.verdict = name_of(result.verdict());
  flight_.end = result.time;
  flight_.seed = result.seed;
  flight_.summary = result.ended ? "the program ended at " + moment(*result.ended)
                                 : (result.interrupted ? "interrupted at " : "the program had not ended after ") +
                                       moment(result.time);
  for (std::size_t i = 0; i < result.judgements.size(); ++i) {
    const Judgement& judgement = result.judgements[i];
    flight_.asked.push_back({scenario_.expectations[i].text, std::string(runtime::name_of(judgement.verdict)),
                             judgement.time, judgement.reason, judgement.evidence});
  }
  return std::move(flight_);
}

}  // namespace rmpl::runtime
