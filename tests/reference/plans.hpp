// A planner of its own, which looks at every state: how soon a goal can be reached at all (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "automata/state.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::reference {

/// The fewest cycles to a state that entails the goal, by one control off idle a cycle, no forbidden step taken or left
/// to time alone, where one thing happens at a time: what needs no time, or else one timed transition. Nothing where
/// there is no such state, or only such as do not stay by themselves. Exponential in the plant.
std::optional<std::size_t> fewest_cycles(const Step& step, const automata::Modes& modes, const automata::Formula& goal);

/// Whether time alone takes away no mode that the goal names.
bool lasts(const automata::Plant& plant, const automata::Formula& goal);

}  // namespace rmpl::reference
