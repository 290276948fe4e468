// Plants in sampled time for PRISM.
// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>

#include "automata/step/plant_step.hpp"
#include "verifier/export/question.hpp"
#include "verifier/search/limits.hpp"

namespace rmpl::verifier {

/// A Markov decision process, or a Markov chain where there is one control action: a module a component, a step a
/// period, with the probabilities of semantics 3; the label `target` is where the question's target holds. Throws
/// base::InputError where PRISM cannot say it: a bound on faults, impossible modes that may be drawn, hazards that
/// change for ever. Throws LimitReached; a combination of modes counts as a state.
void write_prism(std::ostream& out, automata::PlantStep& step, const ExportQuestion& question, automata::Ticks period,
                 const Limits& limits);

}  // namespace rmpl::verifier
