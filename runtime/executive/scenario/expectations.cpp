// Verdicts with their times and reasons.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/expectations.hpp"

#include <algorithm>
#include <utility>

#include "automata/controls.hpp"
#include "automata/logic/given.hpp"
#include "automata/time/checked_ticks.hpp"
#include "base/check.hpp"
#include "base/error.hpp"
#include "runtime/executive/scenario/circumstances.hpp"
#include "runtime/executive/scenario/moment.hpp"
#include "runtime/reasoning/estimate/set_aside.hpp"

namespace rmpl::runtime {
namespace {

using automata::Expectation;
using automata::Ticks;
using Verdict = Judgement::Verdict;

/// Nothing where it lies beyond the end of time.
std::optional<Ticks> deadline(const Expectation& expectation, std::optional<Ticks> since) {
  if (!since || !expectation.within) return std::nullopt;
  return automata::checked_sum(*since, *expectation.within);
}

/// The first event of a kind, or null.
const Event* find(const CycleRecord& record, Event::Kind kind) {
  const auto at =
      std::find_if(record.events.begin(), record.events.end(), [&](const auto& e) { return e.kind == kind; });
  return at == record.events.end() ? nullptr : &*at;
}

}  // namespace

bool lasts_to_the_end(const Expectation& expectation) {
  switch (expectation.kind) {
    case Expectation::Kind::never:
    case Expectation::Kind::never_finished:
    case Expectation::Kind::goal_conflict:
    case Expectation::Kind::no_plan:
      return true;
    case Expectation::Kind::eventually:
    case Expectation::Kind::finished:
      return false;
  }
  return false;
}

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::met:
      return "met";
    case Verdict::failed:
      return "failed";
    case Verdict::undecided:
      return "undecided";
  }
  CHECK(false && "every verdict has a name");
  return {};
}

namespace {

std::vector<automata::Formula> knowledge_asked_by(const automata::Scenario& scenario) {
  std::vector<automata::Formula> atoms;
  for (const Expectation& expectation : scenario.expectations) {
    collect_knowledge(expectation.condition, atoms);
    if (expectation.after) collect_knowledge(*expectation.after, atoms);
  }
  return atoms;
}

}  // namespace

Expectations::Expectations(const automata::Plant& plant, automata::Theory& theory, const automata::Program& program,
                           const automata::Scenario& scenario)
    : plant_(plant),
      theory_(theory),
      program_(program),
      insight_(plant, knowledge_asked_by(scenario)),
      judgements_(scenario.expectations.size()) {
  for (const Expectation& expectation : scenario.expectations) {
    if (expectation.truth && scenario.rules_only) {
      throw base::InputError(
          to_text(expectation.origin) + ": 'expect " + expectation.text +
          "' reads modes of the plant, but the plant is declared 'rules only'; expect the estimate instead");
    }
    Watch watch{&expectation, ask(expectation.condition), std::nullopt, std::nullopt};
    if (expectation.after) {
      watch.after = ask(*expectation.after);
    } else {
      watch.since = Ticks{};
    }
    watches_.push_back(watch);
  }
}

Expectations::Question Expectations::ask(const automata::Formula& formula) {
  if (has_knowledge(formula)) return {.formula = &formula, .handle = {}, .by_command = {}, .knows = true};
  return {.formula = &formula,
          .handle = theory_.encode(formula),
          .by_command = {},
          .commanded = automata::speaks_of_control(plant_, formula)};
}

bool Expectations::holds_as_known(const automata::Formula& formula) {
  const automata::Formula known = with_knowledge(formula, [&](const automata::Formula& atom) {
    if (atom.knowing != automata::Knowing::no_plan) return insight_.answer(atom, *record_->estimator, counted_);
    return no_plan(record_->goals, record_->outcome, record_->left_out, about(plant_, atom), plant_);
  });
  const auto given = automata::assignments_of(plant_, command_);
  return theory_.entails(estimate_.known, theory_.encode(automata::with_values(known, given)));
}

bool Expectations::holds(Question& question, const Side& side) {
  if (question.knows) return holds_as_known(*question.formula);
  const bool commanded_anew = question.commanded && commanded_anew_;
  if (commanded_anew) {
    const auto [at, fresh] = question.by_command.try_emplace(command_);
    if (fresh) {
      const auto given = automata::assignments_of(plant_, command_);
      at->second = theory_.encode(automata::with_values(*question.formula, given));
    }
    question.handle = at->second;
  }
  if (side.changed || commanded_anew) question.answer = theory_.entails(side.known, question.handle);
  return question.answer;
}

void Expectations::know(const CycleRecord& record) {
  commanded_anew_ = command_ != record.command;
  command_ = record.command;
  const auto renew = [](Side& side) {
    side.changed = side.next != side.known;
    if (side.changed) side.known = side.next;
  };
  const auto add_modes = [&](Side& side, const automata::Modes& modes) {
    side.next.clear();
    automata::append_known(plant_, modes, side.next);
  };
  add_modes(estimate_, record.estimate);
  record_ = &record;
  counted_ = without(record.observations, record.set_aside);
  estimate_.next.insert(estimate_.next.end(), counted_.begin(), counted_.end());
  renew(estimate_);
  if (record.truth == nullptr) return;
  add_modes(truth_, *record.truth);
  renew(truth_);
}

void Expectations::observe(const CycleRecord& record, bool ended) {
  know(record);
  for (std::size_t i = 0; i < watches_.size(); ++i) judge(watches_[i], judgements_[i], record, ended);
}

std::string Expectations::evidence(const Expectation& expectation, const CycleRecord& record) const {
  const std::string what = circumstances(expectation.condition, record, plant_, expectation.truth);
  const std::string done = deed(record, plant_);
  return what + (what.empty() || done.empty() ? "" : "; ") + done;
}

void Expectations::judge(Watch& watch, Judgement& judgement, const CycleRecord& record, bool ended) {
  const Ticks now = record.time;
  const Expectation& expectation = *watch.expectation;
  const Side& side = expectation.truth ? truth_ : estimate_;
  // Both are asked in every cycle, also when decided: an answer is renewed only in the cycle in which knowledge
  // changes.
  const bool condition = holds(watch.condition, side);
  const bool triggered = watch.after && holds(*watch.after, side);
  if (judgement.verdict != Verdict::undecided) return;
  if (!watch.since && triggered) watch.since = now;
  const auto due = deadline(expectation, watch.since);
  const bool late = due && now > *due;
  switch (expectation.kind) {
    case Expectation::Kind::eventually:
    case Expectation::Kind::finished: {
      const bool finished = expectation.kind == Expectation::Kind::finished;
      if (finished && ended && !condition) {
        judgement = {Verdict::failed, now, "the program ended while the condition was false",
                     evidence(expectation, record)};
      } else if (watch.since && (finished ? ended : condition) && !late) {
        judgement = {Verdict::met, now, {}, {}};
      } else if (late || (due && now == *due)) {
        judgement = {Verdict::failed, now, "not by " + moment(*due),
                     finished ? places(record.marking, program_) : evidence(expectation, record)};
      }
      break;
    }
    case Expectation::Kind::never:
      if (watch.since && condition && !late) {
        judgement = {Verdict::failed, now, "the condition became true", evidence(expectation, record)};
      } else if (late || (due && now == *due)) {
        judgement = {Verdict::met, now, {}, {}};
      }
      break;
    case Expectation::Kind::never_finished:
      if (ended && condition && !late) {
        judgement = {Verdict::failed, now, "the program ended", evidence(expectation, record)};
      } else if (ended || late || (due && now == *due)) {
        judgement = {Verdict::met, now, {}, {}};  // it ends once only
      }
      break;
    case Expectation::Kind::goal_conflict:
      if (const Event* event = find(record, Event::Kind::goal_conflict)) {
        judgement = {Verdict::failed, record.start, "goals contradicted each other", event->message};
      }
      break;
    case Expectation::Kind::no_plan:
      if (const Event* event = find(record, Event::Kind::no_plan)) {
        judgement = {Verdict::failed, record.start, "a goal had no plan",
                     (event->component ? plant_[*event->component].name + ": " : "") + event->message};
      }
      break;
  }
}

Judgement Expectations::at_the_end(const Watch& watch, const CycleRecord& last) const {
  switch (watch.expectation->kind) {
    case Expectation::Kind::never:
      return {Verdict::met, last.time, watch.since ? "" : "the condition after 'after' never came true", {}};
    case Expectation::Kind::never_finished:
    case Expectation::Kind::goal_conflict:
    case Expectation::Kind::no_plan:
      return {Verdict::met, last.time, {}, {}};
    case Expectation::Kind::finished:
      return {Verdict::failed, last.time, "the program had not ended at the end of the run",
              places(last.marking, program_)};
    case Expectation::Kind::eventually:
      if (!watch.since) return {Verdict::failed, last.time, "the condition after 'after' never came true", {}};
      return {Verdict::failed, last.time, "the condition did not become true before the end of the run",
              evidence(*watch.expectation, last)};
  }
  return {};
}

void Expectations::close(const CycleRecord& last, bool interrupted) {
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    Judgement& judgement = judgements_[i];
    if (judgement.verdict != Verdict::undecided) continue;
    if (interrupted) {
      judgement.reason = "the run was interrupted at " + moment(last.time);
    } else {
      judgement = at_the_end(watches_[i], last);
    }
  }
}

bool Expectations::waiting() const {
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    if (judgements_[i].verdict != Verdict::undecided) continue;
    const bool has_deadline = watches_[i].expectation->within && watches_[i].since;
    if (has_deadline || !lasts_to_the_end(*watches_[i].expectation)) return true;
  }
  return false;
}

bool Expectations::watching() const {
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    if (judgements_[i].verdict != Verdict::undecided) continue;
    if (lasts_to_the_end(*watches_[i].expectation)) return true;
  }
  return false;
}

}  // namespace rmpl::runtime
