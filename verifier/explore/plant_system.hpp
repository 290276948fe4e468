// A plant beside an observer, as a symbolic transition system.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/explore/observer.hpp"
#include "verifier/explore/situation.hpp"
#include "verifier/explore/system.hpp"

namespace verifier {

/// A state is what a step leads to, closed under waiting: every step starts from it at once. Where part of a zone may
/// wait and part may not (a clock is already beyond an exit's upper bound), they are separate states.
///
/// Clocks, in this order: the observer's stopwatch where it runs, then those of the live components.
class PlantSystem : public TransitionSystem {
 public:
  /// Keeps references. `start` are the situations to start in.
  PlantSystem(Situations& situations, Observer& observer, const std::vector<SituationId>& start);

  void initial(const Visit& visit) override;
  void successors(const SymbolicState& state, const Visit& visit) override;
  [[nodiscard]] bool accepts(const SymbolicState& state) const override;

  /// A discrete part, taken apart.
  static SituationId situation_of(std::uint64_t discrete) { return SituationId(discrete >> phase_bits); }
  static Phase phase_of(std::uint64_t discrete) { return static_cast<Phase>(discrete & ((1u << phase_bits) - 1)); }

  /// `Label::wait` of a state that has not waited; else it is a position in `Situation::waits`.
  static constexpr std::uint32_t no_wait = UINT32_MAX;

 private:
  static constexpr unsigned phase_bits = 2;

  /// Visits the state entered with `zone`, as it is when it has waited in each way that it can.
  void enter(SituationId id, Phase phase, unsigned faults, const Zone& zone, Label label, const Visit& visit) const;
  [[nodiscard]] bool within(Zone& zone, const Box& box, SituationId id, Phase phase) const;
  [[nodiscard]] bool wait(Zone& zone, const Box& box, SituationId id, Phase phase) const;
  [[nodiscard]] bool in_time(Zone& zone, Phase phase) const;
  [[nodiscard]] std::size_t clock_of(automata::ComponentId component, SituationId id, Phase phase) const;
  [[nodiscard]] std::vector<ClockLimits> limits(SituationId id, Phase phase) const;

  Situations& situations_;
  Observer& observer_;
  const std::vector<SituationId>& start_;
};

}  // namespace verifier
