// Probabilities beside value iteration in rational numbers: always within the bounds, which are near to each other.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/probability.hpp"
#include "verifier/markov/probability.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;
using reference::Rational;

/// Digits that the twin has for what is no rational number.
const Rational rounding = Rational(1) / boost::multiprecision::pow(boost::multiprecision::cpp_int(10), 40);

void check(const verifier::Likelihood& found, const Rational& exact) {
  // Bounds have at most the digits of a long double; a sum of doubles that are below it holds them exactly.
  const auto rational = [](verifier::Real value) {
    const auto high = static_cast<double>(value);
    return Rational(high) + Rational(static_cast<double>(value - static_cast<verifier::Real>(high)));
  };
  const Rational lower = rational(found.probability.lower);
  const Rational upper = rational(found.probability.upper);
  RC_ASSERT(lower <= exact + rounding);
  RC_ASSERT(exact <= upper + rounding);
  RC_ASSERT(upper - lower <= upper / 1'000'000);
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
    check(*answer.only, exact.least);
  } else {
    check(*answer.least, exact.least);
    check(*answer.greatest, exact.greatest);
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

}  // namespace
}  // namespace rmpl::property
