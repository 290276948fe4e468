// Faults by name: what a component breaks into, and from where.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/state.hpp"

namespace rmpl::verifier {

/// A component goes into a fault mode.
struct Fault {
  automata::ComponentId component;
  automata::ModeId mode;
  auto operator<=>(const Fault&) const = default;
};

/// A component goes from one mode into a fault mode.
struct FaultStep {
  automata::ComponentId component;
  automata::ModeId from, to;
  auto operator<=>(const FaultStep&) const = default;
};

}  // namespace rmpl::verifier
