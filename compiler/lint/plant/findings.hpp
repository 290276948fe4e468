// What lint finds in plants, as data: a function a finding, decided by proof. Texts are made of it elsewhere.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "compiler/lint/plant/analysis.hpp"

namespace rmpl::compiler {

// Of a plant with a possible state, in order of component.

/// Modes that no state has, whatever the modes of the others are.
std::vector<PlantMode> find_impossible_modes(const PlantAnalysis& analysis);
/// Possible modes that are never reached (plant_reach.hpp).
std::vector<PlantMode> find_unreachable_modes(const PlantAnalysis& analysis);
/// Initial modes that no initial state has, where there are initial states.
std::vector<PlantMode> find_impossible_initial_modes(const PlantAnalysis& analysis);
/// Transitions from modes that are reached whose guards follow from no modes that are reached and no command.
std::vector<PlantTransition> find_impossible_guards(const PlantAnalysis& analysis);

/// Two untimed nominal transitions without weights from one mode into different ones, with modes and controls that
/// imply both guards, and what the guards read there.
struct Overlap {
  automata::ComponentId component;
  automata::TransitionId first, second;
  std::vector<automata::Assignment> context;
  std::vector<automata::Assignment> read;
};
std::vector<Overlap> find_overlapping_guards(PlantAnalysis& analysis);

/// A nominal transition from a mode that is reached, and what goes before it wherever its guard holds: an untimed
/// nominal transition, or faults whose probabilities leave nothing.
struct Shadow {
  automata::ComponentId component;
  automata::TransitionId transition;
  std::vector<automata::TransitionId> by;
};
std::vector<Shadow> find_shadowed_transitions(PlantAnalysis& analysis);

/// Nominal transitions to the mode that they set out from, which is reached, with which no nominal transition that
/// leads elsewhere is ever enabled (of one that takes time: none that does): without them the plant does the same.
std::vector<PlantTransition> find_idle_transitions(PlantAnalysis& analysis);

/// Nominal transitions whose weight, below 1, is of no account: those that take time, and are not one of several
/// outcomes; and those beside which none without time bounds that leads elsewhere is ever enabled.
std::vector<PlantTransition> find_unused_weights(PlantAnalysis& analysis);
/// Others whose weight, below 1, is of no account while all controls are idle: untimed ones that may be enabled then,
/// and beside which none without time bounds that leads elsewhere is then.
std::vector<PlantTransition> find_weights_unused_at_rest(PlantAnalysis& analysis);

/// Nominal transitions within finite time bounds, which are counted from when their mode was entered, whose guards, by
/// then, do not hold: they read a command, and hold under no modes while none is given; or they read none, and hold in
/// no initial state and together with no guard by which the mode is entered. Guards that depend on the component's own
/// mode are left out.
std::vector<PlantTransition> find_late_guards(PlantAnalysis& analysis);

/// Values of control variables that nothing allows, in modes that are reached.
std::vector<automata::Assignment> find_impossible_commands(PlantAnalysis& analysis);
/// A mode that is reached, and possible under some command, but not while nothing is commanded; with the idle values
/// that it contradicts, each by itself, or else all together.
struct IdleContradiction {
  PlantMode mode;
  std::vector<automata::Assignment> idle;
};
std::vector<IdleContradiction> find_idle_contradictions(PlantAnalysis& analysis);
/// Values of control variables, not idle, in place of which the idle value could stand wherever they are read: to
/// exchange the two, in the control variable and in all that is set equal to it, changes no constraint and no guard,
/// and nothing that is observed. Sufficient: others may have no effect either.
std::vector<automata::Assignment> find_unread_commands(const PlantAnalysis& analysis);
/// Components with guarded nominal transitions between modes that are reached, on which no control variable has any
/// influence, through whatever chain of constraints and components. None where there are no controls.
std::vector<automata::ComponentId> find_uncommanded_components(const PlantAnalysis& analysis);

/// Two modes of a component that no observation tells apart.
struct AlikeModes {
  automata::ComponentId component;
  automata::ModeId first, second;
  /// Attributes of the component that always differ between the two, and are not observed.
  std::vector<automata::VariableId> would_tell;
};
/// What observations never tell apart, of modes that are reached, in modes of the others that are reached and under
/// whatever command. What takes hundreds of observations to decide is not among it. None where nothing is observed.
struct Indistinguishable {
  std::vector<AlikeModes> modes;  ///< nominal ones
  std::vector<AlikeModes>
      faults;  ///< that also mean the same to other components' guards, and are left in the same ways
  /// Faults that look like each nominal mode of the component, and mean the same to other components' guards.
  std::vector<PlantMode> undetectable;
};
Indistinguishable find_indistinguishable(PlantAnalysis& analysis);

/// A fault that is reached, and a goal to which nothing leads any more once it has happened, whatever is commanded and
/// whatever modes the other components are in.
struct BlockedGoal {
  PlantMode fault;
  PlantMode goal;
};
/// Of these goals, in order of fault, then goal. Asks so many questions and no more: what they leave open is not told.
std::vector<BlockedGoal> find_blocked_goals(PlantAnalysis& analysis, const std::vector<PlantMode>& goals);

/// A state that is reached, and cannot be left (semantics 7), of one part of the plant.
struct StuckState {
  std::vector<automata::ComponentId> components;
  std::vector<automata::ModeId> start;  ///< of these components
  std::vector<automata::ModeId> modes;  ///< of these components
  automata::Ticks period;               ///< the length of a cycle
  std::size_t cycles = 0;               ///< that lead there
  std::vector<automata::ModeId> next;   ///< modes that they are led to together with controls idle, which is impossible
};
/// One a part at most, in cycles of the greatest duration that divides all time bounds of the part, without faults.
/// Looks at parts of few states only.
std::vector<StuckState> find_stuck_states(const automata::Plant& plant);

}  // namespace rmpl::compiler
