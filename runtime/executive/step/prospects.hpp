// What may come in one cycle: commands that could be sent, transitions with their time windows, faults (semantics 3).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/step/plant_step.hpp"

namespace rmpl::runtime {

/// Something that may come in the cycle from `begin` to `end`.
struct Prospect {
  enum class Kind {
    command,     ///< a control has another value than the command has; all else being as it is
    transition,  ///< a component goes to a mode that is no fault
    stay,        ///< a component that might leave its mode keeps it
    fault        ///< a component goes to a fault mode
  };
  /// When a timed transition may be taken, in time since the start.
  struct Window {
    automata::Ticks from;
    automata::Ticks to;  ///< perhaps infinite; then it is taken at the latest
  };
  Kind kind = Kind::transition;
  automata::Assignment what;  ///< a control with its value, or a mode variable with the mode after the cycle
  std::optional<automata::ComponentId> component;  ///< of all but commands
  /// That the component is in that mode at the end, whatever the others do; 0 where the window opens later, and of
  /// commands.
  double probability = 0;
  std::optional<Window> window;   ///< of a timed transition, of several the one that opens first
  automata::Origin origin;        ///< of the transition
  std::vector<std::string> lets;  ///< of a command: the nominal transitions that only it enables, `engine: off -> on`
};

/// What may come in a state under a command, in order: commands by control and value, then components by declaration,
/// each with its transitions, then its staying; then faults likewise. A command that the model does not tolerate in
/// these modes is left out. `step` is of the plant.
std::vector<Prospect> prospects(automata::PlantStep& step, const automata::SystemState& state,
                                const automata::ControlAction& action, automata::Ticks begin, automata::Ticks end);

}  // namespace rmpl::runtime
