// Codes of the registry: lint of plants, what can never be and what is decided by chance.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array lint_plant_table = {
    CodeInfo{Code::unreachable_mode, "mode that is never entered",
             "No initial state has the mode, and no transition that could ever be taken leads to it: there is "
             "none, or the guards of all that there are can never hold, or they set out from modes that are "
             "never entered themselves. It is decided with mode constraints and interconnections, each "
             "component in all modes that it can reach. Where some instances of the type do enter it, it is "
             "no more than a note.",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  mode ajar   { position = shut };
  open, ajar -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
    CodeInfo{Code::impossible_guard, "guard that can never hold",
             "In whatever modes the components can enter and whatever is commanded, the guard does not follow: it "
             "contradicts the constraint of the mode that the transition leaves, or the interconnections, or "
             "nothing that can happen implies it. The transition is never taken.",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
  open   -> closed when cmd = none & position = shut;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
    CodeInfo{Code::impossible_mode, "mode that contradicts the interconnections",
             "The constraint of the mode cannot hold together with the interconnections, in whatever modes "
             "the other components are; or it contradicts itself. A state with this mode is impossible: its "
             "probability is dropped.",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  valve.position = shut;
  control valve.cmd default none;
  observe valve.position;
})",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
    CodeInfo{Code::overlapping_guards, "guards that overlap without weights",
             "Two untimed nominal transitions leave one mode for different modes, there are modes and a "
             "command that enable both, and neither has a weight: chance decides between them, evenly. The modes "
             "of the example can each be entered; whether times allow them together is not asked. Make "
             "the guards exclude each other, or say with `with` how likely each is.",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide, between };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  mode ajar   { position = between };
  closed -> ajar when cmd != none;
  open, ajar -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide, between };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  mode ajar   { position = between };
  closed -> ajar when cmd = close;
  open, ajar -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
    CodeInfo{Code::shadowed_transition, "transition that another one always preempts",
             "Whenever the guard of this nominal transition holds, another one preempts it: an untimed nominal "
             "transition, if this one has time bounds, or faults that are certain. The transition is never taken.",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
  open   -> closed when cmd = close in [5 s, 9 s];
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
  open   -> closed when cmd = none in [5 s, 9 s];
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
    CodeInfo{Code::no_initial_state, "initial modes that contradict each other",
             "The initial modes of the components contradict the interconnections, whichever are drawn: the "
             "plant has no state to begin with, and nothing can be reached. Likewise a model program that tells a "
             "contradiction at once, or one against its constraints.",
             R"(component Door {
  input  cmd  : { none, open };
  output seen : { shut, wide };
  initial open;
  mode closed { seen = shut };
  mode open   { seen = wide };
  closed -> open when cmd = open;
}
plant House {
  inner, outer : Door;
  inner.seen = shut | outer.seen = shut;
  control inner.cmd default none;
  control outer.cmd default none;
  observe inner.seen, outer.seen;
})",
             R"(component Door {
  input  cmd  : { none, open };
  output seen : { shut, wide };
  initial closed;
  mode closed { seen = shut };
  mode open   { seen = wide };
  closed -> open when cmd = open;
}
plant House {
  inner, outer : Door;
  control inner.cmd default none;
  control outer.cmd default none;
  observe inner.seen, outer.seen;
})"},
    CodeInfo{Code::impossible_initial_mode, "initial mode that is never the first",
             "The mode has an initial probability, but contradicts the interconnections in whatever initial "
             "modes the other components are. Its probability is dropped, and the rest counts for more than "
             "was written. Likewise a branch of a draw before the start of a model program.",
             R"(component Door {
  input  cmd  : { none, open };
  output seen : { shut, wide };
  initial closed 0.5, open 0.5;
  mode closed { seen = shut };
  mode open   { seen = wide };
  closed -> open when cmd = open;
}
plant House {
  inner : Door;
  outer : Door { initial open; };
  inner.seen = shut | outer.seen = shut;
  control inner.cmd default none;
  control outer.cmd default none;
  observe inner.seen, outer.seen;
})",
             R"(component Door {
  input  cmd  : { none, open };
  output seen : { shut, wide };
  initial closed 0.5, open 0.5;
  mode closed { seen = shut };
  mode open   { seen = wide };
  closed -> open when cmd = open;
}
plant House {
  inner, outer : Door;
  control inner.cmd default none;
  control outer.cmd default none;
  observe inner.seen, outer.seen;
})"},
    CodeInfo{Code::stuck_plant, "plant that gets stuck",
             "A state can be reached from which every step leads to modes that contradict the "
             "interconnections, whatever is commanded: two components are forced by time, say, into modes "
             "that exclude each other. There all probabilities would be dropped. It is looked for in cycles "
             "of the greatest duration that divides all time bounds, without faults, and only in parts of the "
             "plant that are small and have nothing to do with the rest; `tcca-check stuck` looks everywhere.",
             R"(component Arm {
  output place : { inside, outside };
  initial stowed;
  mode stowed   { place = inside };
  mode deployed { place = outside };
  stowed -> deployed in [10 s, 20 s];
}
plant Rover {
  left, right : Arm;
  left.place = inside | right.place = inside;  // they would collide
  observe left.place, right.place;
})",
             R"(component Arm {
  output place : { inside, outside };
  initial stowed;
  mode stowed   { place = inside };
  mode deployed { place = outside };
  stowed -> deployed in [10 s, 20 s];
}
plant Rover {
  left, right : Arm;
  observe left.place, right.place;
})"},
    CodeInfo{Code::contradictory_interconnections, "interconnections that contradict each other",
             "The interconnections cannot hold together, whatever the modes are: every state is impossible.",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  valve.position = shut;
  valve.position = wide;
  control valve.cmd default none;
  observe valve.position;
})",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
    CodeInfo{Code::impossible_command, "command that contradicts the model",
             "The control variable can never have the value, as mode constraints and interconnections exclude "
             "it in all modes; or its idle value contradicts a mode that is reached. To command it, or nothing, is a "
             "contradiction then, from which everything follows: every guard is enabled.",
             R"(component Valve {
  input  cmd      : { none, open, close, vent };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  valve.cmd != vent;
  control valve.cmd default none;
  observe valve.position;
})",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
};

}  // namespace

std::span<const CodeInfo> lint_plant_codes() { return lint_plant_table; }

}  // namespace rmpl::grammar
