// Claims on probabilities.
// SPDX-License-Identifier: MIT
#include "verifier/claims/probability_claim.hpp"

#include "automata/step/plant_step.hpp"
#include "base/error.hpp"
#include "verifier/markov/report.hpp"
#include "verifier/safety/fault_tree.hpp"

namespace rmpl::verifier {

using automata::PlantProperty;

namespace {

Verdict verdict_of(const Measure& measure) {
  const bool holds = measure.at_least ? measure.lower >= measure.bound : measure.upper <= measure.bound;
  const bool violated = measure.at_least ? measure.upper < measure.bound : measure.lower > measure.bound;
  return holds ? Verdict::holds : violated ? Verdict::violated : Verdict::undecided;
}

}  // namespace

ProbabilityAnswer probability_of(const Subject& subject, const ProbabilityQuestion& question, const Limits& limits) {
  automata::PlantStep step(subject.plant);
  if (subject.program != nullptr) return probability(*subject.program, step, question, limits);
  // A fault tree is decided by diagrams, whatever its size.
  if (auto decided = static_probability(step, question, limits)) return *std::move(decided);
  return probability(step, question, limits);
}

Claim check_probability(const Subject& subject, const PlantProperty& stated, const CheckOptions& free,
                        const Bounds& bounds, const Limits& limits) {
  ProbabilityQuestion question;
  question.target = stated.formula;
  question.entailed = free.entailed;
  question.period = free.period;
  question.faults = free.faults;
  question.commands = free.commands;
  question.from = free.from;
  if (!stated.within.is_infinite()) question.within = stated.within;
  // Whatever is commanded: the claim has to hold of the worst commands.
  question.least = stated.at_least;
  question.greatest = !stated.at_least;
  ProbabilityAnswer found;
  try {
    found = probability_of(stated.of_program ? subject : Subject{subject.plant}, question, limits);
  } catch (const base::InputError& error) {
    throw base::InputError("property \"" + stated.name + "\": " + error.what());
  }
  Property asked = Safety{stated.formula, {}, false};
  if (stated.of_program) {
    asked = ProgramProperty{.kind = ProgramProperty::Kind::never,
                            .formula = stated.formula,
                            .text = to_text(stated.formula, subject.plant.variables)};
  }
  Claim claim{.name = stated.name,
              .origin = stated.origin,
              .question = {asked, free, bounds},
              .expect_violated = stated.expect_violated,
              .answer = {}};
  claim.measure = Measure{.within = stated.within, .bound = stated.bound, .at_least = stated.at_least};
  claim.answer.limit = found.limit;
  claim.answer.startless = found.startless;
  claim.answer.progress = found.progress;
  const auto& likelihood = found.only ? found.only : stated.at_least ? found.least : found.greatest;
  if (found.limit || !likelihood) return claim;
  const auto [lower, upper] = as_doubles(likelihood->probability);
  claim.measure->lower = lower;
  claim.measure->upper = upper;
  claim.measure->text = number_text(likelihood->probability);
  claim.answer.verdict = verdict_of(*claim.measure);
  return claim;
}

}  // namespace rmpl::verifier
