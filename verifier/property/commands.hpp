// Which control actions are free to be taken in a step (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/state.hpp"
#include "base/function_ref.hpp"

namespace rmpl::verifier {

enum class Commands {
  none,  ///< all controls idle
  one,   ///< idle, or any one control variable off its idle value
  any    ///< every combination
};

/// Whether that many control variables may be off their idle values at once.
bool permits(Commands commands, std::size_t off_idle);

/// Every free control action, each once: first idle, then in declaration order of controls and values. One at a time,
/// as `any` may be very many.
void for_each_action(const automata::Plant& plant, Commands commands,
                     base::FunctionRef<void(const automata::ControlAction&)> visit);

/// Whether the control action is among them.
bool is_free(const automata::Plant& plant, Commands commands, const automata::ControlAction& action);

}  // namespace rmpl::verifier
