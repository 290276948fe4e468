// Commands that lead in a circle: what is achieved and undone on it.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "runtime/reasoning/reconfigure/reason.hpp"

namespace rmpl::runtime {

/// What a component achieves in a circle, and what undoes that.
struct Circle {
  TransitionOf there, back;
};

/// Of states that nominal steps lead through, the last of which is the first again: the component that moves first, how
/// it leaves its mode, and how it comes back to it.
Circle circle_in(const automata::Plant& plant, std::span<const automata::Modes> states);

/// Such as `'relay' from 'open' to 'closed' (bus.tcca:7) is undone by 'closed' to 'open' (bus.tcca:8)`.
std::string to_text(const Circle& circle, const automata::Plant& plant);

}  // namespace rmpl::runtime
