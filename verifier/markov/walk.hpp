// How likely a chain comes to what is wanted, step by step from the start.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "verifier/markov/process.hpp"

namespace rmpl::verifier {

/// What is known at some step.
struct Reached {
  Units step = 0;
  Enclosure probability;  ///< of having come to a wanted state by then
};

/// What is not followed, as a probability of coming to what is wanted by the last step: it counts as unknown.
struct Tolerance {
  Real ignored = 0;  ///< what is less likely than that, where it stands at a step
  Real all = 0;      ///< so much besides, of all steps together: the least likely, as soon as time allows it
  Real part = 0;     ///< in an episode, such a part of what it is itself
};

/// What a state leads to, as far as it has been worked out.
struct KnownRow {
  Row row;                          ///< edges to what is wanted come first
  Real less_likely_than = 0;        ///< that `Process::rows` was asked for
  std::size_t wanted = 0;           ///< how many of the edges lead to what is wanted
  std::vector<Prospect> prospects;  ///< by edge, of where it leads
};

/// By number of the state: for several walks of one process.
using KnownRows = std::vector<std::optional<KnownRow>>;

/// The probabilities at these steps, ascending, of a process whose states have one choice at most. What is not
/// followed is part of the bounds.
///
/// A state is worked out as far as can matter where it is as likely as it is. What is followed is a distribution over
/// points. Where one step after the other leads to the same points, until a long clock comes to a bound, all of these
/// steps are one power of a matrix. Throws LimitReached.
std::vector<Reached> walk(Process& process, const std::vector<Units>& steps, const Tolerance& tolerance,
                          KnownRows& known, Meter& meter);

}  // namespace rmpl::verifier
