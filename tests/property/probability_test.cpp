// Probabilities beside value iteration in rational numbers: always within the bounds, which are near to each other.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/property/advice.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/loop_probability.hpp"
#include "tests/reference/probability.hpp"
#include "verifier/markov/loop_process.hpp"
#include "verifier/markov/plant_process.hpp"
#include "verifier/markov/probability.hpp"
#include "verifier/markov/prospects.hpp"
#include "verifier/markov/walk.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;
using reference::Rational;

/// Digits that the twin has for what is no rational number.
const Rational rounding = Rational(1) / boost::multiprecision::pow(boost::multiprecision::cpp_int(10), 40);

void check(const verifier::Enclosure& found, const Rational& exact, double precision = 1e-6) {
  // Bounds have at most the digits of a long double; a sum of doubles that are below it holds them exactly.
  const auto rational = [](verifier::Real value) {
    const auto high = static_cast<double>(value);
    return Rational(high) + Rational(static_cast<double>(value - static_cast<verifier::Real>(high)));
  };
  const Rational lower = rational(found.lower);
  const Rational upper = rational(found.upper);
  RC_ASSERT(lower <= exact + rounding);
  RC_ASSERT(exact <= upper + rounding);
  RC_ASSERT(upper - lower <= upper * Rational(precision));
}

/// Modes in which a formula holds.
std::function<bool(const automata::Modes&)> holds(automata::PlantStep& step, const automata::Formula& formula,
                                                  bool entailed) {
  return [&step, handle = step.theory().encode(formula), entailed](const automata::Modes& modes) {
    const auto store = automata::assignments_of(step.plant(), modes);
    return entailed ? step.theory().entails(store, handle) : step.theory().allows(store, handle);
  };
}

void compare(const Model& model, const automata::Formula& target) {
  const std::size_t steps = up_to(0, 4);
  const Ticks period = Ticks::of_seconds(chance(70) ? 1 : 2);
  reference::Question asked;
  asked.target = target;
  asked.entailed = chance(30);
  asked.commands = chance(40)   ? reference::Question::Commands::none
                   : chance(60) ? reference::Question::Commands::one
                                : reference::Question::Commands::any;
  verifier::ProbabilityQuestion question;
  question.target = target;
  question.entailed = asked.entailed;
  question.period = period;
  // Rounded down to whole steps.
  question.within = Ticks{static_cast<std::int64_t>(steps) * period.count + (chance(30) ? period.count / 2 : 0)};
  question.commands = static_cast<verifier::Commands>(asked.commands);
  const reference::Step slow(model.plant);
  const reference::Probabilities exact = reference::probabilities(slow, asked, period, steps);
  automata::PlantStep step(model.plant);
  const verifier::ProbabilityAnswer answer = verifier::probability(step, question, {});
  RC_ASSERT(!answer.limit.has_value());
  if (answer.only) {
    RC_ASSERT(exact.least == exact.greatest);
    check(answer.only->probability, exact.least);
  } else {
    check(answer.least->probability, exact.least);
    check(answer.greatest->probability, exact.greatest);
  }
}

RC_GTEST_PROP(Probability, HoldsTheExactOne, ()) {
  const Model model = *models();
  compare(model, *formulas(model.plant.variables, all_variables(model.plant), 1));
}

RC_GTEST_PROP(Probability, HoldsTheExactOneWhereModesExcludeEachOther, ()) {
  const Model model = *models({.tangled = true});
  compare(model, *formulas(model.plant.variables, all_variables(model.plant), 1));
}

/// What is walked, at some steps up to `last`, with nearly every clock a long one: kept apart, and the start of an
/// episode. Something may be left out.
void compare_walked(verifier::Process& process, std::size_t last, verifier::Meter& meter,
                    const std::function<std::optional<Rational>(std::size_t)>& exactly) {
  std::vector<verifier::Units> steps{static_cast<verifier::Units>(last)};
  if (chance(50)) steps.insert(steps.begin(), static_cast<verifier::Units>(up_to(0, last)));
  const bool coarse = chance(30);
  verifier::KnownRows known;
  verifier::Tolerance tolerance{coarse ? 1e-3L : 1e-40L, 0, 0};
  if (coarse) tolerance.all = pick<verifier::Real>({0, 1e-2L, 0.5L});
  if (coarse) tolerance.part = pick<verifier::Real>({0, 1e-2L, 0.5L});
  auto reached = verifier::walk(process, steps, tolerance, known, meter);
  while (process.tells_more_apart()) {
    known.clear();
    reached = verifier::walk(process, steps, tolerance, known, meter);
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::optional<Rational> exact = exactly(static_cast<std::size_t>(steps[i]));
    RC_PRE(exact.has_value());
    RC_TAG(*exact == 0 ? "never" : "some day");
    check(reached[i].probability, *exact, coarse ? 1 : 1e-9);
  }
}

/// What may be known beforehand of how likely the target can become.
std::optional<verifier::Prospects> prospects_of(const automata::Plant& plant, const reference::Question& asked,
                                                verifier::Commands commands, Ticks period, std::size_t steps,
                                                verifier::Meter& meter) {
  const std::vector<automata::Assignment> from;
  return verifier::Prospects(
      plant, {asked.target, asked.entailed, commands, from, period, static_cast<verifier::Units>(steps)}, meter);
}

verifier::Walked walked_of(automata::PlantStep& step, const reference::Question& asked, Ticks period,
                           const std::optional<verifier::Prospects>& prospects, std::size_t last) {
  return {.period = period,
          .wanted = holds(step, asked.target, asked.entailed),
          .from = {},
          .left_out = {},
          .for_ever = false,
          .longest_in_state = static_cast<verifier::Units>(pick<std::size_t>({0, 0, 1, 2, 4, 8})),
          .prospects = prospects ? &*prospects : nullptr,
          .steps = static_cast<verifier::Units>(last)};
}

reference::Question something_rare(const automata::Plant& plant) {
  reference::Question asked;
  asked.commands = reference::Question::Commands::none;
  asked.entailed = chance(70);
  const automata::Component& component = pick(plant.components);
  asked.target = automata::conjunction_of(
      std::vector{automata::Assignment{component.mode, automata::ValueId(up_to(0, component.modes.size() - 1))}});
  if (chance(30)) asked.target = *formulas(plant.variables, all_variables(plant), 1);
  return asked;
}

/// Under the commands that make the target most likely, no more than was foreseen of the modes to start in.
RC_GTEST_PROP(Probability, ProspectsAreNeverExceeded, ()) {
  const Model model = *models({.tangled = chance(30)});
  reference::Question asked = something_rare(model.plant);
  asked.commands = chance(40) ? reference::Question::Commands::none : reference::Question::Commands::one;
  const Ticks period{pick<std::int64_t>({Ticks::per_second, Ticks::per_second / 2})};
  const std::size_t steps = up_to(0, 4);
  const verifier::Limits limits;
  verifier::Meter meter(limits);
  const auto prospects = prospects_of(model.plant, asked, static_cast<verifier::Commands>(asked.commands), period,
                                      std::max<std::size_t>(steps, 1), meter);
  automata::PlantStep step(model.plant);
  verifier::Real foreseen = 0;
  for (const verifier::Draw& draw : verifier::initial_draws(step, {}, meter).outcomes) {
    const verifier::Prospect prospect = prospects->of(draw.modes);
    foreseen += draw.probability.upper * prospect.within(static_cast<verifier::Units>(steps));
  }
  const reference::Step slow(model.plant);
  const Rational exact = reference::probabilities(slow, asked, period, steps).greatest;
  RC_TAG(foreseen == 0 ? "never" : foreseen < 1 ? "less than certain" : "perhaps certain");
  const auto high = static_cast<double>(verifier::rounding::up(foreseen, 8));
  RC_ASSERT(exact <= Rational(std::nextafter(high, 2.0)) + rounding);
}

RC_GTEST_PROP(Probability, EpisodesAreFollowedOnce, ()) {
  const Model model = *models({.tangled = chance(30)});
  const reference::Question asked = something_rare(model.plant);
  const Ticks period{pick<std::int64_t>({Ticks::per_second, Ticks::per_second, Ticks::per_second / 2})};
  const reference::Step slow(model.plant);
  automata::PlantStep step(model.plant);
  const verifier::Limits limits;
  verifier::Meter meter(limits);
  const std::size_t last = up_to(1, 9);
  std::optional<verifier::Prospects> prospects;
  if (chance(70)) prospects = prospects_of(model.plant, asked, verifier::Commands::none, period, last, meter);
  const verifier::Walked walked = walked_of(step, asked, period, prospects, last);
  verifier::PlantProcess process(step, verifier::Commands::none, walked, true, meter);
  compare_walked(process, last, meter, [&](std::size_t steps) -> std::optional<Rational> {
    return reference::probabilities(slow, asked, period, steps).least;
  });
}

/// What is asked of a program with its plant.
enum class Loops { answers, episodes };

void compare_loop(const Model& model, bool knows, Loops loops) {
  automata::Program program = (knows ? *programs_that_know(model.plant) : *programs(model.plant)).program;
  for (automata::Location& location : program.locations) {
    if (!knows) break;
    location.apart = false;
    location.goal_constraints.clear();
  }
  const reference::Question asked = something_rare(model.plant);
  const Ticks period{pick<std::int64_t>({Ticks::per_second, Ticks::per_second / 2})};
  const std::size_t last = up_to(1, 8);
  const reference::Step slow(model.plant);
  automata::PlantStep step(model.plant);
  const auto reconfigurer = runtime::make_reconfigurer(step, nullptr, period);
  const reference::Adviser adviser = adviser_of(*reconfigurer);
  const auto exactly = [&](std::size_t steps) {
    return reference::loop_probability(program, slow, adviser, asked, period, steps);
  };
  if (loops == Loops::answers) {
    verifier::ProbabilityQuestion question;
    question.target = asked.target;
    question.entailed = asked.entailed;
    question.period = period;
    question.within = Ticks{static_cast<std::int64_t>(last) * period.count};
    const std::optional<Rational> exact = exactly(last);
    RC_PRE(exact.has_value());
    const verifier::ProbabilityAnswer answer = verifier::probability(program, step, question, {});
    check(answer.only->probability, *exact);
    return;
  }
  const verifier::Limits limits;
  verifier::Meter meter(limits);
  std::optional<verifier::Prospects> prospects;
  if (chance(70)) prospects = prospects_of(model.plant, asked, verifier::Commands::any, period, last, meter);
  const verifier::Walked walked = walked_of(step, asked, period, prospects, last);
  verifier::Loop loop(program, step, *reconfigurer, verifier::TimeModel::sampled(period), 0, meter, {});
  const verifier::Outlook::Question outlooked{asked.target, asked.entailed, period, 1e-9L};
  verifier::Outlook outlook(program, model.plant, outlooked, meter);
  verifier::LoopProcess process(loop, step, walked, true, chance(80), chance(70) ? &outlook : nullptr, meter);
  compare_walked(process, last, meter, exactly);
}

Model small_plant() {
  Shape shape;
  shape.max_components = 2;
  shape.max_attributes = 3;
  shape.commanded = chance(50);
  shape.tangled = chance(30);
  return *models(shape);
}

/// Of two or three that have nothing to do with each other, so that some of it does not matter.
Model plant_of_parts() {
  Shape shape;
  shape.max_components = chance(70) ? 1 : 2;
  shape.max_modes = chance(80) ? 2 : 3;
  shape.max_attributes = 2;
  shape.timed = chance(50);
  shape.commanded = chance(70);
  shape.rewards = chance(30);
  return *side_by_side(shape, 2, 3);
}

RC_GTEST_PROP(Probability, HoldsTheExactOneUnderAProgram, ()) {
  compare_loop(small_plant(), chance(30), Loops::answers);
}

RC_GTEST_PROP(Probability, EpisodesAreFollowedOnceUnderAProgram, ()) {
  compare_loop(small_plant(), chance(30), Loops::episodes);
}

RC_GTEST_PROP(Probability, HoldsTheExactOneOfParts, ()) { compare_loop(plant_of_parts(), false, Loops::answers); }

RC_GTEST_PROP(Probability, EpisodesOfPartsAreFollowedOnce, ()) {
  compare_loop(plant_of_parts(), false, Loops::episodes);
}

}  // namespace
}  // namespace rmpl::property
