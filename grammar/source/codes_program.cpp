// Codes of the registry: control programs.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array program_table = {
    CodeInfo{Code::clock_never_started, "clock never started",
             "The condition reads a clock that no step starts: every atom over it would be false for ever.",
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
             "The definition calls itself again without a step in between that takes time: it would start itself for "
             "ever within one instant.",
             R"(Poll() :: { Poll() }
Main() :: { Poll() })",
             R"(Poll() :: { when valve = open donext Poll() }
Main() :: { Poll() })"},
    CodeInfo{Code::non_tail_recursion, "recursion that is not the last step",
             "A definition may call itself only as the last thing that it does, and not inside its own `do … watching` "
             "or `maintaining`: then the call is a way back to its start. Anything else would need a stack.",
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
             "The program starts at the definition that no other calls, and here are several. `--main NAME`, or `main "
             "NAME` in a scenario, decides.",
             R"(Start() :: { engine = on }
Stop() :: { engine = off })",
             R"(Start() :: {
  engine = on;
  Stop()
}
Stop() :: { engine = off })"},
    CodeInfo{
        Code::no_entry, "no entry point",
        "No definition can be the start: each is called by another, there is none, or `--main` names none of them.",
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
             "The parameter is used where this argument cannot stand: a value where a variable is needed, a constraint "
             "where a name is.",
             R"(Open(v) :: { v = open }
Main() :: { Open(valve = open) })",
             R"(Open(v) :: { v = open }
Main() :: { Open(valve) })"},
    CodeInfo{Code::model_program, "only in model programs",
             "`choose`, and declarations of variables, belong to model programs: they describe what the plant does. A "
             "control program says what it should do.",
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
             "A control program was expected, and what is given or named holds none.", R"(// test.scn
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
             "A scenario flies one control program, and the compiled document that it names holds several. Name the "
             "source of "
             "the one, or compile it by itself.",
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
             "`surprise`, `noplan`, `possible` and `likely` ask what the executive knows. They stand in conditions of "
             "control programs, in expectations, and in what is claimed of a program. A model tells what is so, and a "
             "goal what should be: neither speaks of knowledge. `expect truth` does not either, nor does what stands "
             "between the parentheses of `possible` and `likely`.",
             R"(Main() :: {
  surprise;
  engine = off
})",
             R"(Main() :: {
  when surprise donext engine = off
})"},
    CodeInfo{
        Code::goal_out_of_reach, "goal that nothing achieves",
        "A goal is a constraint over modes and attributes. No command makes `false` true. Of a model program a goal "
        "names what some location tells: nothing else can come about.",
        R"(Main() :: {
  false;
  engine = off
})",
        R"(Main() :: {
  engine = on;
  engine = off
})"},
    CodeInfo{Code::control_only, "only in control programs",
             "`each` says which goals are pursued where not all of them have a plan together. A model program has no "
             "goals: it tells what holds.",
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
