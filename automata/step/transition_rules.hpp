// The rules of semantics 3: what one component may do in one step, given which guards the store implies. Pure.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::automata {

/// What one component may do in one step: go to `mode` (staying is going to its own mode) with `probability` > 0.
struct Move {
  ModeId mode;
  double probability;
};

/// The transitions of one component that its mode and the guards allow; time bounds are not looked at yet.
struct Enabled {
  std::vector<TransitionId> faults;   ///< guard holds, weight above zero
  std::vector<TransitionId> untimed;  ///< nominal, without time bounds, weight above zero
  std::vector<TransitionId> timed;    ///< nominal, with time bounds
};

/// One more enabled transition, to its place. Those for which `can_ever_be_taken` is false have none.
void add_enabled(Enabled& enabled, const Component& component, TransitionId transition);

/// Whether a transition has any weight: one without is never taken.
inline bool can_ever_be_taken(const Transition& t) { return t.weight.kind == Weight::Kind::none || t.weight.value > 0; }

/// The enabled ones of the transitions out of a mode; `implied(transition)` answers for their guards.
template <class Implied>
Enabled enabled_in(const Component& component, ModeId mode, const Implied& implied) {
  Enabled result;
  for (std::size_t t = 0; t < component.transitions.size(); ++t) {
    const Transition& transition = component.transitions[t];
    if (transition.from != mode || !can_ever_be_taken(transition) || !implied(TransitionId(t))) continue;
    add_enabled(result, component, TransitionId(t));
  }
  return result;
}

/// What the enabled faults leave to the nominal transitions in a step of length `step` that ends with the clock at
/// `clock`: in [0, 1], and 0 only where they leave nothing. A step of length 0 is an instant, in which rates weigh
/// nothing.
double nominal_share(const Component& component, const Enabled& enabled, Ticks clock, Ticks step);

/// Whether what the component may do rests on its clock: a mode none of whose timed exits is enabled does not ask it.
bool clock_matters(const Component& component, const Enabled& enabled);

/// What the component may do in a step of length `step` that ends with its clock at `clock`: every mode that is
/// possible by exact comparison of times, each once, in order of mode. The probabilities sum to 1; one that is too
/// small for a double is given as the least normal one, so that what is possible has a positive probability, and
/// nothing else has.
std::vector<Move> moves_of(const Component& component, ModeId mode, const Enabled& enabled, Ticks clock, Ticks step);

/// Whether an enabled restart starts the clock of the component anew. It does so in every step, be it one that ends in
/// the same mode: an untimed transition takes all that faults leave, so that nothing just stays. Hence the modes and
/// the command before a step tell which clocks start anew, together with the modes after it; an outcome need not.
bool restarts(const Component& component, const Enabled& enabled);
bool has_restarts(const Plant& plant);

/// The modes with a positive initial probability.
std::vector<Move> initial_moves_of(const Component& component);

/// Whether the moves of all components, by component, can lead to `next`, before its consistency is looked at. It holds
/// also where the product of the probabilities is too small for a double.
bool lead(const std::vector<std::vector<Move>>& moves, const Modes& next);

/// The system state after moving to `next` at `now`: a clock starts anew when its mode changes, and where a restart is
/// enabled in it (`restarted`, by component).
SystemState advance(const SystemState& state, const std::vector<bool>& restarted, const Modes& next, Ticks now);

}  // namespace rmpl::automata
