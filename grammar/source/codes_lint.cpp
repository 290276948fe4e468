// Codes of the registry: what is allowed, and most likely meant otherwise.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array lint_table = {
    CodeInfo{Code::duplicate_transition, "transition given twice",
             "Two transitions have the same source, target, guard and time bounds. Both count: their weights, risks or "
             "probabilities add up. One of them was most likely meant otherwise.",
             R"(component Valve {
  input cmd : { none, open, close };
  initial closed;
  mode closed;
  mode opened;
  closed -> opened when cmd = open;
  closed -> opened when cmd = open;
  opened -> closed when cmd = close;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
})",
             R"(component Valve {
  input cmd : { none, open, close };
  initial closed;
  mode closed;
  mode opened;
  closed -> opened when cmd = open;
  opened -> closed when cmd = close;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
})"},
    CodeInfo{
        Code::condition_never_holds, "condition never holds",
        "No state of the plant satisfies the condition: the domains, the mode constraints and the interconnections "
        "contradict it. A wait for it never ends, a step that depends on it is never reached, and a watch for it "
        "watches nothing. So it is where it speaks of a command: a program knows modes and readings, not what it "
        "commands. "
        "In a model program a condition holds where what is told entails it: this one follows from "
        "nothing that is told anywhere the program can come to, whatever is commanded. What is seen is not told. Where "
        "nothing is told of a variable that a plant may connect, the finding is a note.",
        "P() :: {\n  when engine = on & engine = off donext valve = open\n}",
        "P() :: {\n  when engine = on donext valve = open\n}"},
    CodeInfo{Code::condition_always_holds, "condition always holds",
             "Every state of the plant satisfies the condition, or the constraints of a model program entail it, so it "
             "decides nothing. If that is meant, write `true`.",
             "P() :: {\n  if engine = on | engine != on thennext valve = open\n}",
             "P() :: {\n  if engine = on thennext valve = open\n}"},
    CodeInfo{Code::condition_out_of_reach, "condition speaks of what the plant cannot reach",
             "States of the plant satisfy the condition, but from its initial modes none of them can be reached, "
             "whatever is commanded and whatever fails.",
             R"(// main.rmpl
P() :: {
  when tap = ajar donext tap = open
}
// plant.tcca
component Tap {
  input cmd : { none, open };
  initial closed;
  mode closed;
  mode open;
  mode ajar;
  closed, ajar -> open when cmd = open;
}
plant Sink {
  cold : Tap { initial ajar; };
  control cold.cmd default none;
  tap : Tap;
  control tap.cmd default none;
})",
             R"(// main.rmpl
P() :: {
  when cold = ajar donext cold = open
}
// plant.tcca
component Tap {
  input cmd : { none, open };
  initial closed;
  mode closed;
  mode open;
  mode ajar;
  closed, ajar -> open when cmd = open;
}
plant Sink {
  cold : Tap { initial ajar; };
  control cold.cmd default none;
  tap : Tap;
  control tap.cmd default none;
})"},
    CodeInfo{Code::contradicting_goals, "goals contradict each other",
             "Two threads ask for different modes of one component in the same cycle. Such a cycle commands nothing. "
             "The notes show where the two goals stand, and when they meet. Where the second goal can also come first, "
             "so that it takes a plant that does this and not that, the finding is a note. The plant is in modes that "
             "it can have at the start, come to in the first cycle, and ever come to; from cycle to cycle any time "
             "passes, the same for all clocks. In a model program: two "
             "constraints begin to be told together and contradict each other, so that it never comes to that.",
             "P() :: {\n  engine = on,\n  engine = off\n}", "P() :: {\n  engine = on;\n  engine = off\n}"},
    CodeInfo{Code::step_never_reached, "step is never reached",
             "The step before this one never ends: `always`, `whenever`, or a wait for a condition that never holds.",
             "P() :: {\n  always engine = on;\n  valve = open\n}",
             "P() :: {\n  always engine = on,\n  valve = open\n}"},
    CodeInfo{Code::goal_on_fault_mode, "goal on a fault mode",
             "A goal is reached by commands, and no command leads into a fault mode. The goal only holds if the fault "
             "happens.",
             R"(// main.rmpl
P() :: {
  tap = stuck
}
// plant.tcca
component Tap {
  input cmd : { none, open };
  initial closed;
  mode closed;
  mode open;
  fault stuck;
  closed -> open when cmd = open;
  any -> stuck with 0.01;
}
plant Sink {
  tap : Tap;
  control tap.cmd default none;
})",
             R"(// main.rmpl
P() :: {
  tap = open
}
// plant.tcca
component Tap {
  input cmd : { none, open };
  initial closed;
  mode closed;
  mode open;
  fault stuck;
  closed -> open when cmd = open;
  any -> stuck with 0.01;
}
plant Sink {
  tap : Tap;
  control tap.cmd default none;
})"},
    CodeInfo{Code::irreversible_goal, "goal that takes an irreversible step",
             "The goal is only reached by an irreversible step: no transitions lead back. The executive takes such a "
             "step only for a goal that names where it leads. This note shows where a program asks for one.",
             R"(// main.rmpl
P() :: {
  latch = open
}
// plant.tcca
component Latch {
  input cmd : { none, fire };
  initial closed;
  mode closed;
  mode open;
  closed -> open when cmd = fire;
}
plant Probe {
  latch : Latch;
  control latch.cmd default none;
})",
             R"(// main.rmpl
P() :: {
  latch = open
}
// plant.tcca
component Latch {
  input cmd : { none, fire, reset };
  initial closed;
  mode closed;
  mode open;
  closed -> open when cmd = fire;
  open -> closed when cmd = reset;
}
plant Probe {
  latch : Latch;
  control latch.cmd default none;
})"},
    CodeInfo{
        Code::clock_started_twice, "clock that runs is started again",
        "A clock of the program is never reset: a second start changes nothing, and what waits for the clock "
        "afterwards does not wait anew. A clock of a definition's own (`clock t;` at its start) starts anew with "
        "each call.",
        "P() :: {\n  t = 0;\n  when t >= 5 s donext valve = open;\n  t = 0;\n  when t >= 5 s donext valve = closed\n}",
        "P() :: {\n  t = 0;\n  when t >= 5 s donext valve = open;\n  u = 0;\n  when u >= 5 s donext valve = closed\n}"},
    CodeInfo{
        Code::unused_definition, "definition that nothing calls",
        "Nothing calls the definition. One that takes nothing may be where another program starts, and is no finding.",
        "$ rmplc lint main.rmpl --main P\nP() :: { valve = open }\nQ(x) :: { x = closed }",
        "$ rmplc lint main.rmpl --main P\nP() :: { valve = open; Q(valve) }\nQ(x) :: { x = closed }"},
    CodeInfo{Code::unused_parameter, "parameter that is never used",
             "The definition does the same whatever is passed for the parameter.",
             "P() :: { Open(left) }\nOpen(valve) :: { right = open }",
             "P() :: { Open(left) }\nOpen(valve) :: { valve = open }"},
    CodeInfo{Code::unused_clock, "clock that is never read",
             "The clock is declared or started, and no condition reads it.", "P() :: { t = 0; valve = open }",
             "P() :: { t = 0; when t >= 5 s donext valve = open }"},
    CodeInfo{Code::unused_domain, "domain that is never used", "No variable has the domain.",
             R"(domain Level = { low, high };
component Tap {
  initial closed;
  mode closed;
}
plant Sink {
  tap : Tap;
})",
             R"(domain Level = { low, high };
component Tap {
  output flow : Level;
  initial closed;
  mode closed { flow = low };
}
plant Sink {
  tap : Tap;
})"},
    CodeInfo{Code::unused_type, "component or module that is never used",
             "The plant has no instance of it, also not through other modules.",
             R"(component Tap {
  initial closed;
  mode closed;
}
component Drain {
  initial clear;
  mode clear;
}
plant Sink {
  tap : Tap;
})",
             R"(component Tap {
  initial closed;
  mode closed;
}
component Drain {
  initial clear;
  mode clear;
}
plant Sink {
  tap : Tap;
  drain : Drain;
})"},
    CodeInfo{Code::mixed_separators, "`,` and `;` in the same braces",
             "`;` binds tighter than `,`, which is easily misread: in `a; b, c` the step c starts together with a, and "
             "not after it. Inner braces say what is meant.",
             "P() :: {\n  engine = on; valve = open,\n  lamp = on\n}",
             "P() :: {\n  { engine = on; valve = open },\n  lamp = on\n}"},
    CodeInfo{Code::finer_than_cycle, "time finer than the cycle",
             "The executive reads the plant once a cycle. Times that differ by less than a cycle mean the same, and a "
             "bound that is no multiple of the cycle is rounded up to the next.",
             R"(// test.scn
scenario "s" {
  program "main.rmpl";
  plant "plant.tcca";
  cycle 1 s;
  duration 10 s;
  at 2 s observe tap.flow = low for 100 ms;
}
// main.rmpl
P() :: {
  tap = closed
}
// plant.tcca
component Tap {
  output flow : { low, high };
  initial closed;
  mode closed { flow = low };
}
plant Sink {
  tap : Tap;
  observe tap.flow;
})",
             R"(// test.scn
scenario "s" {
  program "main.rmpl";
  plant "plant.tcca";
  cycle 1 s;
  duration 10 s;
  at 2 s observe tap.flow = low for 1 s;
}
// main.rmpl
P() :: {
  tap = closed
}
// plant.tcca
component Tap {
  output flow : { low, high };
  initial closed;
  mode closed { flow = low };
}
plant Sink {
  tap : Tap;
  observe tap.flow;
})"},
    CodeInfo{Code::unused_allowance, "allowance that allows nothing",
             "A comment `lint: allow …` stands where nothing of that code is found: on the line of a finding or on the "
             "one before. What was allowed has been mended, or has moved. In a file that another one brings, "
             "as an import, it is a note: another input set that has the file in common may need it.",
             "// lint: allow RMPL0514 because the threads are on lines of their own\nP() :: { valve = open }",
             "P() :: { valve = open }"},
    CodeInfo{
        Code::allowance_without_reason, "allowance that is not understood",
        "An allowance names codes that lint finds and gives its reason: `// lint: allow RMPL0514 because …`, or the "
        "same between `/*` and `*/`. "
        "Another comment that begins with `lint:` allows nothing.",
        "// lint: allow RMPL0514\nP() :: { engine = on; { valve = open, lamp = on } }",
        "// lint: allow RMPL0514 because the engine comes first\nP() :: { engine = on; valve = open, lamp = on }"},
};

}  // namespace

std::span<const CodeInfo> lint_codes() { return lint_table; }

}  // namespace rmpl::grammar
