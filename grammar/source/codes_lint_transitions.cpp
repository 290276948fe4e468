// Codes of the registry: lint of plants, transitions that do not do what they seem to.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array table = {
    CodeInfo{
        Code::timed_fault, "fault with time bounds",
        "A fault is drawn anew in each step; with time bounds, in each step at whose end the clock is within them. "
        "In how many steps that is depends on the cycle, a step over all of the bounds draws it never, and once "
        "they have passed it cannot happen any more. What is meant by a fault among the outcomes of a transition "
        "that takes time is a mode of its own, from which without bounds the outcome is drawn. A fault with bounds "
        "by itself is a note.",
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
    CodeInfo{
        Code::idle_transition, "transition that changes nothing",
        "A nominal transition leads to the mode that it sets out from, and is never enabled together with one that "
        "leads elsewhere. To stay is to stay: the clock of the mode goes on, so the transition has no effect. Beside "
        "others it has one, as it takes its share of the probability or goes before what takes time. What is to begin "
        "anew is a mode of its own. In a mode without time bounds it is a note.",
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
    CodeInfo{
        Code::unused_weight, "weight that is of no account",
        "Weights say how transitions without time bounds that are enabled together share what is likely, and how the "
        "outcomes of one transition do. A transition beside which no other is ever enabled is taken for certain, "
        "whatever its weight; one that takes time competes with others by its times alone.",
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
        Code::late_guard, "guard that begins after the clock",
        "Time bounds are counted from when the mode was entered, not from when the guard began to hold. A guard that "
        "waits for a command, or that holds wherever the mode is left and never where it is entered, begins to hold at "
        "any time after: where that is past the upper bound, the transition is overdue and is taken in the next step, "
        "without any delay. A delay from a cause is a mode of its own. A lower bound alone, `after 5 s`, may be meant: "
        "before that nothing is obeyed.",
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
};

}  // namespace

std::span<const CodeInfo> lint_transition_codes() { return table; }

}  // namespace rmpl::grammar
