// A plant and a question as a network of timed automata: a process a component, which reads the modes of others.
//
// A run goes on in rounds. A command is chosen, and what each component does follows from it and from the modes as they
// are; then every component rests again, and time may pass. So a round is what the semantics calls a step, whatever
// order the components take it in.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/export/question.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/zone/time_model.hpp"

namespace rmpl::verifier {

/// Going from one mode to another, or staying.
struct ProcessStep {
  automata::ModeId from, to;
  automata::Formula where;  ///< of the modes of others as the round begins, and of controls
  Interval clock;           ///< readings of the component's clock
  bool fault = false;
  bool restarts = false;  ///< the clock is set to 0
};

/// Where a component is between rounds.
struct ProcessRest {
  automata::ModeId mode;
  automata::Formula where;  ///< of the modes of others as the round ends
  Interval clock;           ///< readings with which it begins; time passes up to the greatest
  bool urgent = false;      ///< no time passes
  bool restarts = false;    ///< at least a unit passes, however long, and the clock reads 0 after it
};

struct ComponentProcess {
  bool clocked = false;
  std::vector<automata::ModeId> initial;
  std::vector<ProcessRest> rests;  ///< by mode
  std::vector<ProcessStep> steps;  ///< by mode that they begin in
};

/// Constants are multiples of `time.unit()`. Conditions are over mode variables and controls of the plant.
struct Network {
  TimeModel time;
  std::vector<ComponentProcess> processes;  ///< by component
  std::vector<automata::Formula> possible;  ///< what the modes after a round satisfy: all of it
  automata::Formula target;                 ///< of the modes after a round
  Commands commands = Commands::one;
  unsigned faults = 0;
};

/// What guards say is worked out over the combinations of the few modes and controls that they read. Where these are
/// more than `most_rows`, over those that can be met: then a combination of modes is counted against the limits as a
/// state. Throws LimitReached.
Network network_of(automata::PlantStep& step, const ExportQuestion& question, const Limits& limits,
                   std::size_t most_rows = 4096);

}  // namespace rmpl::verifier
