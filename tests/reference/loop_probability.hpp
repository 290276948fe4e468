// How likely a program with its plant comes to a formula, by a sum over all that may happen in rational numbers: the
// twin of verifier/markov for closed loops in sampled time.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "tests/reference/closed_loop.hpp"
#include "tests/reference/probability.hpp"

namespace rmpl::reference {

/// Of coming within so many cycles to modes in which the target of the question holds; a run ends with the program.
/// Cost: states of the loop, with all clocks, times steps. Nothing where there are too many.
std::optional<Rational> loop_probability(const automata::Program& program, const Step& step, const Adviser& adviser,
                                         const Question& question, automata::Ticks period, std::size_t steps);

}  // namespace rmpl::reference
