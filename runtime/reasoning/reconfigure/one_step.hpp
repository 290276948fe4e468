// One-step reconfiguration: the cheapest control action that achieves the goal in the next state (livingstone, MR).
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// Livingstone's mode reconfiguration (the section of that name): the variables are the control variables. A control
/// action is feasible if in every tracked state the store tolerates it, every mode that nominal transitions may lead a
/// component to is one that the goal permits it, whether timed ones fire or not, and every state that they may lead to
/// entails the goal. (Modes are judged one by one, as in equation 8: where two of them exclude each other this asks too
/// much.) Its cost is the number of control variables off their idle values; of equal costs the first in declaration
/// order of control variables, then values. What cannot be undone is commanded only where the goal names the mode, as
/// the planner does it. `no_plan` where no action achieves the goal in one step.
///
/// Keeps a reference to `step`, and asks its theory; `graph` is as for `make_reconfigurer`.
std::unique_ptr<Reconfigurer> make_one_step_reconfigurer(automata::PlantStep& step,
                                                         std::shared_ptr<const NominalGraph> graph = nullptr);

}  // namespace rmpl::runtime
