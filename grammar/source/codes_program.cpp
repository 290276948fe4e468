// Codes of the registry: control programs.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array program_table = {
    CodeInfo{Code::clock_never_started, "clock never started",
             "The condition reads a clock that no step starts, so each comparison with the clock is always false.",
             R"(Main() :: {
  when t1 >= 30 s donext engine = off
})",
             R"(Main() :: {
  t1 = 0;
  when t1 >= 30 s donext engine = off
})"},
    CodeInfo{Code::clock_not_allowed, "clock where none is allowed",
             "Clocks stand only in conditions: of `if`, `unless`, `when`, `whenever`, `watching` and `maintaining`. A "
             "goal cannot ask for a time. A clock starts at 0 and is never reset.",
             R"(Main() :: {
  t1 = 0;
  t1 >= 30 s;
  engine = off
})",
             R"(Main() :: {
  t1 = 0;
  when t1 >= 30 s donext engine = off
})"},
    CodeInfo{Code::unguarded_recursion, "recursion that never waits",
             "The definition calls itself without a step in between that takes time. It would restart without end "
             "within one instant.",
             R"(Poll() :: { Poll() }
Main() :: { Poll() })",
             R"(Poll() :: { when valve = open donext Poll() }
Main() :: { Poll() })"},
    CodeInfo{
        Code::non_tail_recursion, "recursion that is not the last step",
        "A definition may call itself only as its last step, and not inside its own `do … watching` or `maintaining`. "
        "Such a call is a jump back to the start. Any other recursion would need a stack, and programs have none.",
        R"(Poll() :: {
  when valve = open donext Poll();
  engine = on
}
Main() :: { Poll() })",
        R"(Poll() :: {
  engine = on;
  when valve = open donext Poll()
}
Main() :: { Poll() })"},
    CodeInfo{Code::wrong_argument_count, "wrong number of arguments",
             "The call gives more or fewer arguments than the definition has parameters.", R"(Open(v) :: { v = open }
Main() :: { Open() })",
             R"(Open(v) :: { v = open }
Main() :: { Open(valve) })"},
    CodeInfo{Code::ambiguous_entry, "several entry points",
             "A program starts at the definition that no other definition calls. This program has several such "
             "definitions. Choose one with `--main NAME`, or with `main NAME` in a scenario.",
             R"(Start() :: { engine = on }
Stop() :: { engine = off })",
             R"(Start() :: {
  engine = on;
  Stop()
}
Stop() :: { engine = off })"},
    CodeInfo{Code::no_entry, "no entry point",
             "The program has no definition to start with. Either it has no definitions, or each definition is called "
             "by another one, or `--main` names a definition that does not exist.",
             R"(Start() :: { when valve = open donext Stop() }
Stop() :: { when valve = closed donext Start() })",
             R"(Main() :: { Start() }
Start() :: { when valve = open donext Stop() }
Stop() :: { when valve = closed donext Start() })"},
    CodeInfo{Code::not_in_plant, "not in the plant",
             "The program speaks of a variable or a value that the plant does not have.", R"(// main.rmpl
Main() :: { motor = on }
// plant.tcca
component Engine {
  input cmd : { none, start };
  initial off;
  mode off;
  mode on;
  off -> on when cmd = start;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})",
             R"(// main.rmpl
Main() :: { engine = on }
// plant.tcca
component Engine {
  input cmd : { none, start };
  initial off;
  mode off;
  mode on;
  off -> on when cmd = start;
}
plant Lander {
  engine : Engine;
  control engine.cmd default none;
})"},
    CodeInfo{Code::wrong_argument, "argument that does not fit",
             "The definition uses the parameter in a place that does not permit this argument. Examples: a value where "
             "a variable is needed, a constraint where a name is needed.",
             R"(Open(v) :: { v = open }
Main() :: { Open(valve = open) })",
             R"(Open(v) :: { v = open }
Main() :: { Open(valve) })"},
    CodeInfo{Code::model_program, "only in model programs",
             "Only model programs may contain `choose` and declarations of variables. A model program describes what "
             "the plant does; a control program says what the plant should do.",
             R"(Main() :: {
  choose { engine = on with 0.5, engine = off with 0.5 }
})",
             R"(Main() :: {
  engine = on
})"},
    CodeInfo{Code::contradictory_goal, "goal that contradicts itself",
             "One goal asks for two modes of one component at once.", R"(Main() :: {
  engine = on & engine = off
})",
             R"(Main() :: {
  engine = on;
  engine = off
})"},
    CodeInfo{Code::no_program, "no control program",
             "A control program was expected, but the given or named file contains none.", R"(// test.scn
scenario "opens" {
  program "tap.tcca";
  plant "tap.tcca";
}
// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
})",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
}
// main.rmpl
Main() :: { valve = opened }
// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
})"},
    CodeInfo{Code::several_programs, "several control programs",
             "A scenario flies one control program, but the compiled document that it names contains several. Name the "
             "source of the program, or compile that program alone.",
             R"($ rmplc compile both.scn -o both.json
$ rmplc compile test.scn -o model.json
// test.scn
scenario "opens" {
  program "both.json";
  plant "tap.tcca";
}
// both.scn
scenario "one" {
  program "one.rmpl";
  plant "tap.tcca";
}
scenario "two" {
  program "two.rmpl";
  plant "tap.tcca";
}
// one.rmpl
One() :: { valve = opened }
// two.rmpl
Two() :: { when valve.flow = no donext valve = opened }
// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
})",
             R"($ rmplc compile one.rmpl -o one.json
$ rmplc compile test.scn -o model.json
// test.scn
scenario "opens" {
  program "one.json";
  plant "tap.tcca";
}
// one.rmpl
One() :: { valve = opened }
// two.rmpl
Two() :: { when valve.flow = no donext valve = opened }
// tap.tcca
component Valve {
  input cmd : { none, open };
  output flow : { no, yes };
  initial closed;
  mode closed { flow = no };
  mode opened { flow = yes };
  fault stuck { flow = no };
  closed -> opened when cmd = open;
  any -> stuck with rate 1e-6 / h;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
  observe valve.flow;
})"},
    CodeInfo{Code::knowledge_not_allowed, "knowledge condition not allowed here",
             "`surprise`, `noplan`, `possible` and `likely` ask what the executive knows. They are permitted in:\n\n- "
             "conditions of control programs,\n- expectations of scenarios, without `truth`,\n- properties of "
             "programs.\n\nThey are not permitted elsewhere: a model tells what is true, and a goal says what should "
             "become true. They are not permitted inside the parentheses of `possible` and `likely` either.",
             R"(Main() :: {
  surprise;
  engine = off
})",
             R"(Main() :: {
  when surprise donext engine = off
})"},
    CodeInfo{Code::goal_out_of_reach, "goal that nothing achieves",
             "A goal is a constraint over modes and attributes. No command makes `false` true. A goal for a model "
             "program must name a value that some location of the program tells; no other value can be achieved.",
             R"(Main() :: {
  false;
  engine = off
})",
             R"(Main() :: {
  engine = on;
  engine = off
})"},
    CodeInfo{Code::control_only, "only in control programs",
             "`each` says which goals the executive pursues if no plan achieves all of them together. A model program "
             "has no goals, so it cannot contain `each`.",
             R"(variable valve, lamp : { off, on };
model Main() :: {
  each { always valve = on, always lamp = on }
})",
             R"(variable valve, lamp : { off, on };
model Main() :: {
  always valve = on,
  always lamp = on
})"},
};

}  // namespace

std::span<const CodeInfo> program_codes() { return program_table; }

}  // namespace rmpl::grammar
