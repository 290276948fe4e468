// Codes of the registry: what is allowed, and most likely meant otherwise.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array lint_table = {
    CodeInfo{Code::duplicate_transition, "transition given twice",
             "Two transitions have the same source, target, guard and time bounds. Both count: their weights, rates or "
             "probabilities add up. One of them is probably a mistake.",
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
    CodeInfo{Code::condition_never_holds, "condition never holds",
             "No state of the plant satisfies the condition: the domains, the mode constraints and the "
             "interconnections contradict it. A wait for it never ends, a step that depends on it never runs, and "
             "`watching` it has no effect. A condition on a command never holds either: a program knows modes and "
             "readings, not its own commands.\n\nIn a model program, a condition holds if the told constraints entail "
             "it. No constraints that the program can tell together entail this condition, whatever is commanded. "
             "Observations are not told, so they make no condition true. If the program tells nothing about a variable "
             "of the condition, but a plant may connect that variable, the finding is a note.",
             "P() :: {\n  when engine = on & engine = off donext valve = open\n}",
             "P() :: {\n  when engine = on donext valve = open\n}"},
    CodeInfo{Code::condition_always_holds, "condition always holds",
             "Every state of the plant satisfies the condition, or the constraints of a model program entail it, so "
             "the condition has no effect. If that is intended, write `true`.",
             "P() :: {\n  if engine = on | engine != on thennext valve = open\n}",
             "P() :: {\n  if engine = on thennext valve = open\n}"},
    CodeInfo{Code::condition_out_of_reach, "condition on states that the plant cannot reach",
             "Some states of the plant satisfy the condition, but the plant reaches none of them from its initial "
             "modes, whatever is commanded and whatever fails.",
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
             "Two threads ask for different modes of one component in the same cycle. In such a cycle the executive "
             "sends no command. The notes show both goals and the first cycle in which they conflict. If the conflict "
             "depends on how the plant behaves, the finding is a note. The analysis over-approximates the plant: it "
             "knows which modes are possible at the start, which after the first cycle and which later. Between cycles "
             "it lets any time pass, the same for all clocks.\n\nIn a model program, the two constraints begin to be "
             "told together and contradict each other. Such an instant is impossible.",
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
             "Only an irreversible step achieves the goal: no nominal transitions lead back. The executive takes an "
             "irreversible step only for a goal that names the mode to which the step leads. This note shows where a "
             "program asks for such a step.",
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
        "A clock of the program is never reset. A second start has no effect, so a later wait for the clock may end at "
        "once. A local clock (`clock t;` at the start of a definition) starts with each call.",
        "P() :: {\n  t = 0;\n  when t >= 5 s donext valve = open;\n  t = 0;\n  when t >= 5 s donext valve = closed\n}",
        "P() :: {\n  t = 0;\n  when t >= 5 s donext valve = open;\n  u = 0;\n  when u >= 5 s donext valve = closed\n}"},
    CodeInfo{Code::unused_definition, "definition that nothing calls",
             "No definition calls this one. Lint does not report a definition without parameters, because another "
             "program may start with it.",
             "$ rmplc lint main.rmpl --main P\nP() :: { valve = open }\nQ(x) :: { x = closed }",
             "$ rmplc lint main.rmpl --main P\nP() :: { valve = open; Q(valve) }\nQ(x) :: { x = closed }"},
    CodeInfo{Code::unused_parameter, "parameter that is never used",
             "The definition does not depend on the argument for the parameter.",
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
             "The plant has no instance of the component or module, neither directly nor through other modules.",
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
             "`;` binds tighter than `,`, which is easily misread: in `a; b, c` the step c starts together with a, not "
             "after it. Inner braces make the order explicit.",
             "P() :: {\n  engine = on; valve = open,\n  lamp = on\n}",
             "P() :: {\n  { engine = on; valve = open },\n  lamp = on\n}"},
    CodeInfo{Code::finer_than_cycle, "time finer than the cycle",
             "The executive reads the plant once per cycle. Times that differ by less than a cycle have the same "
             "effect, and a bound is rounded up to the next multiple of the cycle.",
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
             "A comment `lint: allow …` applies to its own line and to the next line. Neither has a finding with this "
             "code: the finding was fixed, or it moved. In an imported file this is a note, because another input set "
             "that shares the file may need the comment.",
             "// lint: allow RMPL0514 because the threads are on lines of their own\nP() :: { valve = open }",
             "P() :: { valve = open }"},
    CodeInfo{Code::allowance_without_reason, "allowance that is not understood",
             "An allowance names codes of lint and gives a reason: `// lint: allow RMPL0514 because …`, or the same "
             "between `/*` and `*/`. Any other comment that begins with `lint:` has no effect.",
             "// lint: allow RMPL0514\nP() :: { engine = on; { valve = open, lamp = on } }",
             "// lint: allow RMPL0514 because the engine comes first\nP() :: { engine = on; valve = open, lamp = on }"},
};

}  // namespace

std::span<const CodeInfo> lint_codes() { return lint_table; }

}  // namespace rmpl::grammar
