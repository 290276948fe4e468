// The Markov structure of a plant in sampled time: what a component draws from, in terms of modes and of its clock.
//
// Given its own mode and clock, the modes that its guards can depend on and the control action, a component draws
// independently of all others (semantics 3). A process over modes and clocks counted in periods is therefore a product
// of small tables, one a component, which is what is told here.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/zone/interval.hpp"

namespace rmpl::verifier {

/// What is enabled, and where: among the modes that are possible under the action.
struct EnabledClass {
  automata::Enabled enabled;
  automata::Formula where;  ///< of modes
};

/// Every set of transitions that can be enabled in a component in `mode` under the action, in the order in which they
/// are met; among modes that are possible the conditions exclude each other. `read` are the components that its guards
/// depend on. Polls for each combination of their modes.
std::vector<EnabledClass> enabled_classes(automata::PlantStep& step, automata::ComponentId component,
                                          automata::ModeId mode, const automata::ControlAction& action,
                                          std::vector<automata::ComponentId> read, Meter& meter);

/// Where the store implies the formula, or (not `certain`) allows it, among the modes that are possible: of modes.
/// `read` are the components that it depends on.
automata::Formula where_holds(automata::PlantStep& step, const automata::Formula& formula, bool certain,
                              std::vector<automata::ComponentId> read, Meter& meter);

/// The reading of a component's clock, in periods, from which on nothing that it may do in `mode` depends on it any
/// more; nothing where a hazard goes on changing for ever.
std::optional<Units> settled_reading(const automata::Component& component, automata::ModeId mode,
                                     automata::Ticks period);

/// Readings, in whole periods as a step begins, over which the same is drawn.
struct Stretch {
  Units first;
  std::optional<Units> last;  ///< none: for ever
  std::vector<automata::Move> moves;
};

/// All readings of a component in `mode` in which that is enabled, in order, `settled` being its `settled_reading`.
std::vector<Stretch> stretches(const automata::PlantStep& step, automata::ComponentId component, automata::ModeId mode,
                               const automata::Enabled& enabled, automata::Ticks period, Units settled);

}  // namespace rmpl::verifier
