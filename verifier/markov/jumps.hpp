// A plant in dense time: where it jumps to, and how soon.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/markov/decision_process.hpp"
#include "verifier/markov/plant_process.hpp"

namespace rmpl::verifier {

/// A continuous-time Markov chain over the states in which time passes. An edge is a jump with all that follows it at
/// once; a state that is wanted, were it for an instant, ends the run.
struct Jumps {
  DecisionProcess chain;         ///< rows are the probabilities of jumps; none: nothing ever happens
  std::vector<Enclosure> rates;  ///< of leaving, per second, by state; 0 where there is no row
};

struct JumpQuestion {
  std::function<bool(const automata::Modes&)> wanted;
  std::vector<automata::Assignment> from;
  std::optional<unsigned> faults_beyond;
};

/// Explores the chain, with all controls idle. Throws base::InputError where something else than rates and exponential
/// densities takes time, or steps that take none go round; LimitReached.
Jumps jumps(automata::PlantStep& step, const JumpQuestion& question, Meter& meter);

}  // namespace rmpl::verifier
