// Verdicts with their times and reasons.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/expectations.hpp"

#include <algorithm>
#include <utility>

#include "automata/time/checked_ticks.hpp"
#include "base/check.hpp"
#include "base/error.hpp"

namespace rmpl::runtime {
namespace {

using automata::Expectation;
using automata::format_seconds;
using automata::Ticks;
using Verdict = Judgement::Verdict;

/// Nothing where it lies beyond the end of time.
std::optional<Ticks> deadline(const Expectation& expectation, std::optional<Ticks> since) {
  if (!since || !expectation.within) return std::nullopt;
  return automata::checked_sum(*since, *expectation.within);
}

}  // namespace

bool lasts_to_the_end(const Expectation& expectation) {
  switch (expectation.kind) {
    case Expectation::Kind::never:
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

Expectations::Expectations(automata::PlantStep& step, const automata::Scenario& scenario)
    : step_(step), judgements_(scenario.expectations.size()) {
  for (const Expectation& expectation : scenario.expectations) {
    if (expectation.truth && scenario.rules_only) {
      throw base::InputError(expectation.origin.file + ":" + std::to_string(expectation.origin.line) + ":" +
                             std::to_string(expectation.origin.column) + ": 'expect " + expectation.text +
                             "' speaks of the truth, but the plant follows the rules only; expect the estimate");
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
  return {&formula, step_.theory().encode(formula)};
}

bool Expectations::holds(Question& question, const Side& side) {
  if (side.changed) question.answer = step_.theory().entails(side.known, question.handle);
  return question.answer;
}

void Expectations::know(const CycleRecord& record) {
  const auto renew = [](Side& side) {
    side.changed = side.next != side.known;
    if (side.changed) side.known = side.next;
  };
  const auto add_modes = [&](Side& side, const automata::Modes& modes) {
    side.next.clear();
    for (std::size_t c = 0; c < modes.size(); ++c) {
      side.next.push_back({step_.plant().components[c].mode, automata::ValueId(modes[c].index())});
    }
  };
  add_modes(estimate_, record.estimate);
  if (record.consistent) {
    estimate_.next.insert(estimate_.next.end(), record.observations.begin(), record.observations.end());
  }
  renew(estimate_);
  if (record.truth == nullptr) return;
  add_modes(truth_, *record.truth);
  renew(truth_);
}

void Expectations::observe(const CycleRecord& record, bool ended) {
  know(record);
  for (std::size_t i = 0; i < watches_.size(); ++i) judge(watches_[i], judgements_[i], record, ended);
}

void Expectations::decide(Judgement& judgement, Verdict verdict, Ticks now, std::string reason) {
  judgement = {verdict, now, std::move(reason)};
}

void Expectations::judge(Watch& watch, Judgement& judgement, const CycleRecord& record, bool ended) {
  const Ticks now = record.time;
  const auto happened = [&](Event::Kind kind) {
    return std::any_of(record.events.begin(), record.events.end(), [&](const Event& e) { return e.kind == kind; });
  };
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
        decide(judgement, Verdict::failed, now, "the program ended without it");
      } else if (watch.since && (finished ? ended : condition) && !late) {
        decide(judgement, Verdict::met, now);
      } else if (late || (due && now == *due)) {
        decide(judgement, Verdict::failed, now, "not by " + format_seconds(*due) + " s");
      }
      break;
    }
    case Expectation::Kind::never:
      if (watch.since && condition && !late) decide(judgement, Verdict::failed, now, "it came true");
      break;
    case Expectation::Kind::goal_conflict:
      if (happened(Event::Kind::goal_conflict)) decide(judgement, Verdict::failed, record.start, "there was one");
      break;
    case Expectation::Kind::no_plan:
      if (happened(Event::Kind::no_plan)) decide(judgement, Verdict::failed, record.start, "a goal was without a plan");
      break;
  }
}

void Expectations::close(Ticks time, bool interrupted) {
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    Judgement& judgement = judgements_[i];
    if (judgement.verdict != Verdict::undecided) continue;
    const Expectation& expectation = *watches_[i].expectation;
    if (interrupted) {
      judgement.reason = "the run was interrupted at " + format_seconds(time) + " s";
      continue;
    }
    switch (expectation.kind) {
      case Expectation::Kind::never:
      case Expectation::Kind::goal_conflict:
      case Expectation::Kind::no_plan:
        decide(judgement, Verdict::met, time);
        break;
      case Expectation::Kind::finished:
        decide(judgement, Verdict::failed, time, "the program had not ended when the run was over");
        break;
      case Expectation::Kind::eventually:
        decide(judgement, Verdict::failed, time,
               watches_[i].since ? "it did not come true before the run was over"
                                 : "what it waits for after 'after' never came true");
        break;
    }
  }
}

bool Expectations::waiting() const {
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    if (judgements_[i].verdict != Verdict::undecided) continue;
    if (!lasts_to_the_end(*watches_[i].expectation)) return true;
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
