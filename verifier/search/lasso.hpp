// Runs without end: a way to a loop, and once around it.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "automata/state.hpp"
#include "verifier/search/search.hpp"

namespace rmpl::verifier {

/// The ways out of modes that are enabled in a step however late it is, so that chance takes them at last where they
/// stay open: per component, the modes that they lead to, ascending.
struct Exits {
  std::vector<std::vector<automata::ModeId>> enabled;
  std::vector<std::vector<automata::ModeId>> open;  ///< those that some joint step takes to a possible state
  auto operator<=>(const Exits&) const = default;
};

/// A path whose last state is the one at position `repeats_from`: from there on it goes round and round.
struct Lasso {
  std::vector<PathState> path;
  std::size_t repeats_from = 0;
};

/// What a system tells of its steps where runs without end are looked for.
class Runs {
 public:
  /// What is so while a step is taken.
  struct Passage {
    const Exits* step =
        nullptr;  ///< what is enabled in it; kept as long as this object is; none where it does not count
    const Exits* wait = nullptr;  ///< the same while time passes before it; none where that is `step`, or none passes
    bool time = false;            ///< time passes before or in it
    std::vector<automata::ComponentId> restarted = {};  ///< whose clocks restarts start anew in it
  };

  virtual ~Runs() = default;
  virtual TransitionSystem& system() = 0;
  /// Whether a loop through the state is one of those looked for. Mostly all are; those of one loop are alike.
  [[nodiscard]] virtual bool counts(const SymbolicState& state) const = 0;
  /// Where each component is.
  virtual automata::Modes modes(std::uint64_t discrete) = 0;
  virtual Passage passage(const SymbolicState& from, const SymbolicState& to, const Label& label) = 0;
};

/// A run that goes round for ever: time passes on it, and an exit without an upper bound that stays enabled is taken at
/// last. Waits in which nothing changes any more, and that no step tells of, are not among them. Nothing where there is
/// no such run. Throws LimitReached.
///
/// States are kept apart unless they are equal: inclusion keeps what can be reached, but not what can be repeated. With
/// the abstraction by lower and upper bounds the graph is finite, and has a cycle where the loop has such a run and
/// only there (S. Tripakis, Checking Timed Büchi Automata Emptiness on Simulation Graphs, 2009; A. Laarman et al.,
/// Multi-core Emptiness Checking of Timed Büchi Automata using Inclusion Abstraction, 2013): the system is to visit
/// states that are so abstracted. Strongly connected components are found by Tarjan's algorithm.
std::optional<Lasso> find_lasso(Runs& runs, Meter& meter);

}  // namespace rmpl::verifier
