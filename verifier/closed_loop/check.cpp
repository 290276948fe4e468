// Checking a program: each property in turn, and round by round where the fewest faults are asked for.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/check.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "verifier/closed_loop/bystanders.hpp"
#include "verifier/closed_loop/cause.hpp"
#include "verifier/closed_loop/searches.hpp"
#include "verifier/cut_set/cut_set_rounds.hpp"
#include "verifier/slice/empty_claims.hpp"

namespace rmpl::verifier {

using Kind = ProgramProperty::Kind;

namespace {

class ProgramCheck {
 public:
  ProgramCheck(const automata::Program& program, automata::PlantStep& step, const std::vector<Property>& properties,
               const CheckOptions& options, const Limits& limits)
      : program_(program),
        step_(step),
        properties_(of_programs(properties)),
        options_(options),
        searches_(program, step, properties_, options, limits),
        answers_(properties_.size()) {}

  std::vector<Answer> run() {
    std::vector<std::size_t> all(properties_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    if (options_.fewest_faults) {
      with_fewest_faults(std::move(all));
    } else {
      round(all, options_.faults.value());
    }
    for (Answer& answer : answers_) answer.startless = startless_;
    return std::move(answers_);
  }

 private:
  /// Decides some properties, with up to so many faults.
  void round(const std::vector<std::size_t>& asked, unsigned faults) {
    searches_.allow_faults(faults);
    std::size_t i = 0;
    try {
      startless_ = searches_.startless();
      for (; i < asked.size(); ++i) decide(asked[i]);
    } catch (const LimitReached& reached) {
      for (; i < asked.size(); ++i) {
        answers_[asked[i]].limit = reached.limit;
        answers_[asked[i]].progress = searches_.progress();
      }
    }
  }

  /// Round by round one fault more, until every property is violated or as many as may be were tried. What a round has
  /// worked out of cycles and plans the next one has.
  void with_fewest_faults(std::vector<std::size_t> open) {
    for (unsigned faults = 0; faults <= options_.faults.value() && !open.empty(); ++faults) {
      for (const std::size_t p : open) answers_[p] = {};
      round(open, faults);
      std::vector<std::size_t> still_open;
      for (const std::size_t p : open) {
        if (answers_[p].witness) {
          answers_[p].fewest_faults = faults;
        } else if (!answers_[p].limit) {
          still_open.push_back(p);
        }
      }
      open = std::move(still_open);
    }
  }

  void decide(std::size_t p) {
    Answer& answer = answers_[p];
    searches_.forget_seen();
    find_violation(p);
    answer.verdict = answer.witness ? Verdict::violated : Verdict::holds;
    answer.progress = searches_.progress();
    answer.cut_sets = searches_.cut_sets();
    if (answer.witness && !options_.cut_sets) find_others(properties_[p], answer);
    if (answer.witness) return;
    answer.vacuous = vacuity_of(properties_[p]);
    answer.cut_off = searches_.cut_off();
    // What would follow is not known, as no time comes in which it would.
    if (answer.cut_off.still) answer.verdict = Verdict::undecided;
  }

  void find_violation(std::size_t p) {
    // What waits for ever does not end either.
    for (std::size_t q = 0; q < p && properties_[p].kind == Kind::termination; ++q) {
      if (properties_[q].kind != Kind::endless_wait || !answers_[q].witness) continue;
      answers_[p].witness = answers_[q].witness;
      answers_[p].same_as = q;
      return;
    }
    if (options_.cut_sets) return find_cut_sets(p);
    answers_[p].witness = searches_.violation(properties_[p], {});
  }

  void find_cut_sets(std::size_t p) {
    Answer& answer = answers_[p];
    CutSetRounds rounds(step_.plant(), options_.faults.value());
    do {
      searches_.allow_faults(rounds.faults());
      searches_.forget_seen();
      try {
        answer.witness = searches_.violation(properties_[p], {});
      } catch (const LimitReached&) {
        answer.cut_sets = searches_.cut_sets();
        rounds.settle(answer);
        answer.witness.reset();
        throw;
      }
    } while (rounds.next(searches_.cut_sets(), searches_.progress().faults));
    answer.cut_sets_complete = options_.faults;
  }

  /// Further missing plans and endless waits, each with another cause than those before it, until there are no more.
  void find_others(const ProgramProperty& property, Answer& answer) {
    const bool plans = property.kind == Kind::no_plan;
    if (!plans && property.kind != Kind::endless_wait) return;
    Query query{plans ? Query::Aim::no_plan : Query::Aim::endless_wait};
    std::set<Cause> known;
    const auto learn = [&](const Witness& witness) {
      for (Cause& cause : causes_of(program_, witness, plans)) known.insert(std::move(cause));
    };
    learn(*answer.witness);
    const auto is_new = [&](const Cause& cause) { return !known.contains(cause); };
    query.fresh = [&](const LoopState& state, const Turn& turn) {
      if (!plans) return is_new(waiting_cause(program_, state.marking));
      const auto cause = [&](const automata::Goals& goals, const runtime::Reason& why, const std::string& reason) {
        return no_plan_cause(program_, state.marking, goals, why, reason);
      };
      const bool whole = turn.answer.outcome == runtime::Reconfiguration::Outcome::no_plan &&
                         is_new(cause(turn.goals, turn.answer.why, turn.answer.reason));
      return whole || std::any_of(turn.left_out.begin(), turn.left_out.end(), [&](const runtime::LeftOut& other) {
               return is_new(cause(other.goals, other.why, other.reason));
             });
    };
    while (auto witness = searches_.search(query, &property)) {
      learn(*witness);
      answer.others.push_back(std::move(*witness));
      answer.progress = searches_.progress();
    }
  }

  /// Why no run at all could violate what holds; nothing where one could.
  std::optional<Vacuity> vacuity_of(const ProgramProperty& property) {
    const auto unless = [](bool found, Vacuity vacuity) { return found ? std::nullopt : std::optional(vacuity); };
    if (property.kind == Kind::finally) {
      const auto any = searches_.search({.aim = Query::Aim::ends_with, .test = [](const LoopState&) { return true; }});
      return unless(any.has_value(), Vacuity::endless);
    }
    if (property.kind == Kind::response) {
      const auto asks =
          searches_.search({.aim = Query::Aim::holds, .test = searches_.holds(property.formula, options_.entailed)});
      return unless(asks.has_value(), Vacuity::unasked);
    }
    if (property.kind != Kind::never || has_knowledge(property.formula)) return std::nullopt;
    Slices slices(step_.plant());
    const auto of_model = vacuity_of_never(slices, property.formula, options_.entailed);
    if (of_model || !property.window.not_before) return of_model;
    ProgramProperty anything = property;
    anything.formula = automata::constant(true);
    anything.fastest = false;
    return unless(searches_.violation(anything, {}).has_value(), Vacuity::over);
  }

  const automata::Program& program_;
  automata::PlantStep& step_;
  std::vector<ProgramProperty> properties_;
  const CheckOptions& options_;
  Searches searches_;
  std::vector<Answer> answers_;
  bool startless_ = false;  ///< known to be
};

/// The answers where bystanders have left and nothing is violated: else a witness needs them, and nothing is told.
/// Takes half of the time at most, so that there is time left for all components.
std::optional<std::vector<Answer>> unviolated(const automata::Program& program, const automata::Plant& plant,
                                              const std::vector<Property>& properties, const CheckOptions& options,
                                              Limits limits) {
  if (!options.slice || options.cut_sets) return std::nullopt;
  if (limits.time) *limits.time /= 2;
  Slices slices(plant);
  if (!slices.start(options.from)) return std::nullopt;
  std::optional<Stage> stage;
  Meter meter(limits);
  try {
    stage = without_bystanders(slices, program, properties, options, meter);
  } catch (const LimitReached&) {
    return std::nullopt;
  }
  if (!stage) return std::nullopt;
  std::vector<Property> own;
  own.reserve(properties.size());
  for (const Property& property : properties) own.push_back(into(stage->part, property));
  CheckOptions terms = options;
  terms.from = stage->part.into(options.from);
  automata::PlantStep step(stage->part.plant());
  const Limits left = remaining(limits, meter.progress());
  std::vector<Answer> answers = ProgramCheck(stage->program, step, own, terms, left).run();
  const bool all_hold = std::all_of(answers.begin(), answers.end(), [](const Answer& answer) {
    return answer.verdict == Verdict::holds && !answer.witness && !answer.limit && !answer.startless;
  });
  return all_hold ? std::optional(std::move(answers)) : std::nullopt;
}

}  // namespace

std::vector<Answer> check(const automata::Program& program, automata::PlantStep& step,
                          const std::vector<Property>& properties, const CheckOptions& options, const Limits& limits) {
  const Meter meter(limits);
  if (auto answers = unviolated(program, step.plant(), properties, options, limits)) return std::move(*answers);
  const Limits left = remaining(limits, meter.progress());
  return ProgramCheck(program, step, properties, options, left).run();
}

}  // namespace rmpl::verifier
