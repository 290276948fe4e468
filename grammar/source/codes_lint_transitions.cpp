// Codes of the registry: lint of plants, transitions that do not do what they seem to.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array lint_transitions_table = {
    CodeInfo{Code::timed_fault, "fault with time bounds",
             "A fault is drawn in each step. With time bounds, it is drawn in each step at whose end the clock is "
             "within the bounds. The number of these steps depends on the cycle. A step that spans the whole interval "
             "never draws the fault, and after the interval the fault cannot happen. To draw a fault when a timed "
             "transition ends, let the transition lead to an intermediate mode, and draw the outcome there without "
             "time bounds. A density has no effect. A fault transition with bounds and without a density that is not "
             "an outcome of a timed transition is a note.",
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
             "A nominal transition leads back to the mode that it leaves, and is never enabled together with a "
             "transition to another mode. The component stays in its mode and the clock of the mode continues, so the "
             "transition has no effect. Together with other transitions it would take a share of the probability, or "
             "preempt timed transitions. A `restart` has an effect if an exit of its mode has time bounds. In a mode "
             "without time bounds the finding is a note.",
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
             "outcomes of one transition. If no other transition is ever enabled together with this one, or none while "
             "all controls are idle, this transition is certain, whatever its weight. A timed transition competes with "
             "others only by its time.",
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
    CodeInfo{
        Code::late_guard, "guard that may begin after its time bounds",
        "Time bounds count from when the mode was entered, not from when the guard began to hold. A guard that waits "
        "for a command, or that never holds as the mode is entered, may begin to hold at any later time. If that time "
        "is past the upper bound, the transition is overdue and is taken in the next step, without any delay. To delay "
        "an effect from its cause, add a mode: let the guard lead to it, and put the time bounds on its exit. A lower "
        "bound alone, `after 5 s`, may be intended: the component then obeys no command before 5 s.",
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
             "The clock of a component counts from the entry into its mode. A transition from a mode to itself is not "
             "an entry, so the time bounds of the other exits continue to count. With `restart` the transition "
             "restarts the clock, like the command that resets a watchdog.",
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
