// A component's part in the rounds of a network, told briefly: what does the same in several modes is told once.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "verifier/export/network.hpp"

namespace rmpl::verifier {

/// Going to a mode, or staying.
struct RoundStep {
  automata::Formula where;  ///< of its own mode and those of others as the round begins, and of controls
  Interval clock;
  std::optional<automata::ModeId> to;  ///< none: it stays
  bool fault = false;
  bool restarts = false;  ///< the clock is set to 0
};

/// How it waits for the next round.
struct RoundRest {
  automata::Formula where;  ///< of its own mode and those of others as the round ends
  Interval clock;           ///< readings with which it begins; time passes up to the greatest
  bool urgent = false;      ///< no time passes
  bool restarts = false;    ///< at least a unit passes, however long, and the clock reads 0 after it
};

struct RoundProcess {
  std::vector<RoundStep> steps;
  std::vector<RoundRest> rests;  ///< none: it never stops time
  std::vector<Units> bounds;     ///< up to which it may wait somewhere, ascending, `unbounded` left out
  bool stops = false;            ///< whether some rest is urgent
  bool renews = false;           ///< whether some rest restarts the clock
};

/// The component's process; its modes are those of the mode variable.
RoundProcess in_rounds(const automata::Plant& plant, automata::ComponentId component, const ComponentProcess& process);

}  // namespace rmpl::verifier
