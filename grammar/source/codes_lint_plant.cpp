// Codes of the registry: lint of plants, what can never be and what is decided by chance.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array lint_plant_table = {
    CodeInfo{Code::unreachable_mode, "mode that is never entered",
             "No initial state has the mode, and no transition that can be taken leads to it. The message gives the "
             "reason, which is one of these:\n\n- No transition leads to the mode.\n- The guards of the transitions to "
             "the mode can never hold.\n- The transitions to the mode leave modes that are never entered "
             "either.\n\nThe analysis uses mode constraints and interconnections, and lets each component be in every "
             "mode that it can reach. If other instances of the type enter the mode, the finding is a note.",
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
             "The transition is never taken: its guard never follows from the model, whatever modes the components "
             "enter and whatever is commanded. Either the guard contradicts the constraint of the mode that the "
             "transition leaves, or it contradicts the interconnections, or no modes and no command imply it.",
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
    CodeInfo{
        Code::impossible_mode, "mode that contradicts the interconnections",
        "The constraint of the mode contradicts itself, or it contradicts the interconnections in whatever modes the "
        "other components are. No state with this mode is possible, and the probability of such states is dropped.",
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
             "Two untimed nominal transitions leave one mode for different modes, some modes and a command enable "
             "both, and neither has a weight. Both are then equally likely. Each mode of the example can be entered; "
             "the analysis does not check whether time bounds permit these modes together. Make the guards exclude "
             "each other, or give each transition its weight with `with`.",
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
             "The nominal transition is never taken: whenever its guard holds, another transition preempts it. Untimed "
             "nominal transitions preempt transitions with time bounds. Faults that are certain preempt all nominal "
             "transitions.",
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
             "All combinations of initial modes contradict the interconnections. The plant has no initial state, so it "
             "reaches no state at all. In a model program, the constraints that are told at the start contradict each "
             "other or the constraints of the whole program.",
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
             "The mode has an initial probability, but contradicts the interconnections in whatever initial modes the "
             "other components are. Its probability is dropped, so the other modes are more likely than the model "
             "says. The same finding applies to a branch of a draw before the start of a model program.",
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
             "The plant can deadlock: it reaches a state from which every step leads to modes that contradict the "
             "interconnections, whatever is commanded. For example, time bounds force two components into modes that "
             "exclude each other. Lint searches without faults, in cycles of the greatest duration that divides all "
             "time bounds, and only in small parts of the plant that are independent of the rest. `tcca-check stuck` "
             "searches the whole plant.",
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
             "The interconnections contradict each other in whatever modes the components are. No state of the plant "
             "is possible.",
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
    CodeInfo{
        Code::impossible_command, "command that contradicts the model",
        "Either mode constraints and interconnections exclude the value of the control variable in all modes, or the "
        "idle value of the control variable contradicts a mode that the plant reaches. While the control variable has "
        "this value, the model is contradictory. A contradiction entails every formula, so every guard is enabled.",
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
