// Runs without end: a way to a loop, and once around it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "verifier/closed_loop/program_system.hpp"
#include "verifier/search/search.hpp"

namespace rmpl::verifier {

/// A path whose last state is the one at position `repeats_from`: from there on it goes round and round.
struct Lasso {
  std::vector<PathState> path;
  std::size_t repeats_from = 0;
};

/// A run that goes round for ever without the program ending: time passes on it, and an exit without an upper bound
/// that stays enabled is taken at last. Waits in which nothing changes any more are not among them. Nothing where there
/// is no such run. Throws LimitReached.
///
/// States are kept apart unless they are equal: inclusion keeps what can be reached, but not what can be repeated. With
/// the abstraction by lower and upper bounds the graph is finite, and has a cycle where the loop has such a run and
/// only there (S. Tripakis, Checking Timed Büchi Automata Emptiness on Simulation Graphs, 2009; A. Laarman et al.,
/// Multi-core Emptiness Checking of Timed Büchi Automata using Inclusion Abstraction, 2013). Its strongly connected
/// components are found by Tarjan's algorithm.
std::optional<Lasso> find_lasso(ProgramSystem& system, Loop& loop, bool after_fault, Meter& meter);

}  // namespace rmpl::verifier
