// How likely a plant comes to a formula, by value iteration in rational numbers: the twin of verifier/markov.
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/time/time.hpp"
#include "tests/reference/reachability.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::reference {

using Rational = boost::multiprecision::cpp_rational;

/// The least and the greatest probability under free commands.
struct Probabilities {
  Rational least, greatest;
};

/// Of coming, within so many steps of a period, to a state in which the target of the question holds. Sums, products
/// and quotients are exact; what is no rational number (exponentials, logarithms, normal densities) has fifty digits.
/// Cost: exponential in the number of steps at worst.
Probabilities probabilities(const Step& step, const Question& question, automata::Ticks period, std::size_t steps);

/// Per mode of a component, the probability of being in it after the step from `before` to `now`, as
/// `Step::distribution`.
std::vector<Rational> exact_distribution(const Step& step, std::size_t component, const automata::SystemState& state,
                                         const automata::ControlAction& action, automata::Ticks before,
                                         automata::Ticks now);

}  // namespace rmpl::reference
