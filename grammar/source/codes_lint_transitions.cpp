// Codes of the registry: lint of plants, transitions that do not do what they seem to.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array lint_transitions_table = {
    CodeInfo{Code::timed_fault, "fault with time bounds",
             "A fault is drawn anew in each step; with time bounds, in each step at whose end the clock is within the "
             "bounds. How many steps these are depends on the cycle. A step over all of the bounds never draws the "
             "fault, and after the bounds it cannot happen. To draw a fault as a timed transition ends, lead the "
             "transition to a mode of its own, and draw the outcome there, without bounds. A density has no "
             "part in it. A fault with bounds and no density, by itself, is a note.",
             R"(component Latch {
  output seen : { moving, locked, jammed };
  initial moving;
  mode  moving { seen = moving };
  mode  locked { seen = locked };
  fault jammed { seen = jammed };
  moving -> { locked with 0.98, jammed with 0.02 } in [1 s, 2 s];
}
plant Door {
  latch : Latch;
  observe latch.seen;
})",
             R"(component Latch {
  output seen : { moving, there, locked, jammed };
  initial moving;
  mode  moving { seen = moving };
  mode  there  { seen = there };
  mode  locked { seen = locked };
  fault jammed { seen = jammed };
  moving -> there in [1 s, 2 s];
  there  -> { locked with 0.98, jammed with 0.02 };
}
plant Door {
  latch : Latch;
  observe latch.seen;
})"},
    CodeInfo{Code::idle_transition, "transition that changes nothing",
             "A nominal transition leads to the mode that it leaves, and is never enabled together with one that leads "
             "elsewhere. Such a step is staying: the clock of the mode goes on, so the transition has no effect. "
             "Beside others it would take its share of the probability, or preempt timed transitions. A `restart` has "
             "an effect where time bounds an exit of its mode. In a mode without time bounds the finding is a note.",
             R"(component Valve {
  input  cmd      : { none, open, keep };
  output position : { shut, between, wide };
  initial closed;
  mode closed  { position = shut };
  mode opening { position = between };
  mode open    { position = wide };
  closed  -> opening when cmd = open;
  opening -> open    when cmd != keep in [2 s, 3 s];
  opening -> opening when cmd = keep;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})",
             R"(component Valve {
  input  cmd      : { none, open };
  output position : { shut, between, wide };
  initial closed;
  mode closed  { position = shut };
  mode opening { position = between };
  mode open    { position = wide };
  closed  -> opening when cmd = open;
  opening -> open in [2 s, 3 s];
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
    CodeInfo{Code::unused_weight, "weight without an effect",
             "Weights divide the probability among untimed transitions that are enabled together, and among the "
             "outcomes of one transition. A transition beside which no other is ever enabled, or none under idle "
             "controls, is certain then, whatever its weight. A timed transition competes with others by its times "
             "alone.",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide, moving, between };
  initial closed;
  mode closed  { position = shut };
  mode open    { position = wide };
  mode closing { position = moving };
  mode ajar    { position = between };
  closed  -> open    when cmd = open;
  open    -> closing when cmd = close;
  closing -> closed in [1 s, 2 s] with 0.9;
  closing -> ajar   in [1 s, 2 s] with 0.1;
  ajar    -> closing when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide, moving, between };
  initial closed;
  mode closed  { position = shut };
  mode open    { position = wide };
  mode closing { position = moving };
  mode ajar    { position = between };
  closed  -> open    when cmd = open;
  open    -> closing when cmd = close;
  closing -> { closed with 0.9, ajar with 0.1 } in [1 s, 2 s];
  ajar    -> closing when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
    CodeInfo{Code::late_guard, "guard that may begin after its time bounds",
             "Time bounds count from when the mode was entered, not from when the guard began to hold. A guard that "
             "waits for a command, or that never holds as the mode is entered, may begin to hold at any later time. If "
             "that is past the upper bound, the transition is overdue and is taken in the next step, without any "
             "delay. Give a delay from a cause a mode of its own. A lower bound alone, `after 5 s`, may be meant: "
             "before it no command is obeyed.",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, wide };
  initial closed;
  mode closed { position = shut };
  mode open   { position = wide };
  closed -> open when cmd = open in [2 s, 3 s];
  open -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})",
             R"(component Valve {
  input  cmd      : { none, open, close };
  output position : { shut, between, wide };
  initial closed;
  mode closed  { position = shut };
  mode opening { position = between };
  mode open    { position = wide };
  closed -> opening when cmd = open;
  opening -> open in [2 s, 3 s];
  open -> closed when cmd = close;
}
plant Feed {
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
})"},
    CodeInfo{Code::timer_goes_on, "self-transition that restarts no clock",
             "The clock of a component counts from when its mode was entered. A transition from a mode to itself is no "
             "entry: the time bounds of the other exits count on. With `restart` it starts the clock anew, as a "
             "command does that kicks a watchdog.",
             R"(component Watchdog {
  input  ping  : { no, yes };
  output alive : { no, yes };
  initial running;
  mode running   { alive = yes };
  mode timed-out { alive = no };
  running -> running   when ping = yes;
  running -> timed-out after 10 s;
}
plant Monitor {
  dog : Watchdog;
  control dog.ping default no;
  observe dog.alive;
})",
             R"(component Watchdog {
  input  ping  : { no, yes };
  output alive : { no, yes };
  initial running;
  mode running   { alive = yes };
  mode timed-out { alive = no };
  running -> running restart when ping = yes;
  running -> timed-out after 10 s;
}
plant Monitor {
  dog : Watchdog;
  control dog.ping default no;
  observe dog.alive;
})"},
};

}  // namespace

std::span<const CodeInfo> lint_transition_codes() { return lint_transitions_table; }

}  // namespace rmpl::grammar
