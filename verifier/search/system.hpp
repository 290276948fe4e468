// The interface between what is explored and how: symbolic states, and the functions that enumerate them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/function_ref.hpp"
#include "base/hash.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/zone/zone.hpp"

namespace rmpl::verifier {

/// A set of states that agree on everything but clock readings.
struct SymbolicState {
  std::uint64_t discrete;  ///< what the system numbers as it likes; states with equal numbers have the same clocks
  unsigned faults;  ///< used so far, as the system counts them: of two states otherwise alike, the one with no more can
                    ///< do all that the other can
  Zone zone;
};

inline std::uint64_t hash_of(const SymbolicState& state) {
  std::uint64_t hash = base::mix(base::mix(base::hash_seed, state.discrete), state.faults);
  for (const Units bound : state.zone.matrix()) hash = base::mix(hash, static_cast<std::uint64_t>(bound));
  return hash;
}

/// How a state came about: numbers that mean something to its system alone.
struct Label {
  std::uint32_t move = 0;
  std::uint32_t wait = 0;
  bool silent = false;  ///< does not count as a step
};

/// A transition system over symbolic states, in the manner of TChecker. Every algorithm runs on any such system; the
/// order in which states are visited is fixed, so that results repeat.
class TransitionSystem {
 public:
  using Visit = base::FunctionRef<void(SymbolicState&&, const Label&)>;

  virtual ~TransitionSystem() = default;
  virtual void initial(const Visit& visit) = 0;
  virtual void successors(const SymbolicState& state, const Visit& visit) = 0;
  /// Whether the state holds what is looked for.
  [[nodiscard]] virtual bool accepts(const SymbolicState& state) const = 0;
  /// Whether a state with faults `a` can do all that one with faults `b` can.
  [[nodiscard]] virtual bool no_more_faults(unsigned a, unsigned b) const { return a <= b; }
  /// How many faults that is.
  [[nodiscard]] virtual unsigned fault_count(unsigned faults) const { return faults; }
  /// Numbers none of which is less for faults `a` than for `b` where `no_more_faults(a, b)`: a quick look before it.
  using FaultMeasures = std::array<Units, 3>;
  [[nodiscard]] virtual FaultMeasures fault_measures(unsigned faults) const { return {-Units{faults}, 0, 0}; }
  /// How far from the start: states with as many faults are explored by this, the least first.
  [[nodiscard]] virtual std::uint32_t rank(std::uint64_t /*discrete*/) { return 0; }
  /// The greatest constants that the clocks of states with this discrete part are compared with from there on. A search
  /// takes one state to cover another up to what can be told apart by them. None: zones are compared as they are.
  virtual void limits([[maybe_unused]] std::uint64_t discrete, std::vector<ClockLimits>& result) { result.clear(); }
};

}  // namespace rmpl::verifier
