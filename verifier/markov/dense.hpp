// Plants in dense time as continuous-time Markov chains with instantaneous steps.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "verifier/markov/probability.hpp"

namespace rmpl::verifier {

/// Where nothing but rates and exponential densities from 0 takes time, and no command is free to be chosen: bounded
/// questions by uniformisation, cut off where what is left has a known bound (A. Jensen: Markoff chains as an aid in
/// the study of Markoff processes, 1953), others by elimination over the jumps. Throws base::InputError, which says
/// what else takes time; LimitReached.
ProbabilityAnswer dense_probability(automata::PlantStep& step, const ProbabilityQuestion& question,
                                    const std::function<bool(const automata::Modes&)>& wanted, Meter& meter);

}  // namespace rmpl::verifier
