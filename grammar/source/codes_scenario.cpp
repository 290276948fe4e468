// Codes of the registry: scenarios.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array scenario_table = {
    CodeInfo{Code::scenario_missing_part, "scenario lacks a part", "A scenario names a program and a plant.",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  expect valve = opened within 5 s;
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
})",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  expect valve = opened within 5 s;
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
    CodeInfo{Code::scenario_repeated_part, "scenario part given twice",
             "A scenario gives its program, plant, cycle, duration and seed at most once each. It gives at most one "
             "initial mode for each component.",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  seed 1;
  seed 2;
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
})",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  seed 1;
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
    CodeInfo{Code::scenario_not_a_mode, "not a mode",
             "`truth` and `fault` set modes of components of the simulated plant. The name on the left must be a "
             "component, and the name on the right one of its modes.",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  truth valve.flow = yes;
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
})",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  truth valve = opened;
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
    CodeInfo{
        Code::scenario_not_observable, "not an observable variable",
        "`observe` in a scenario overrides a sensor. The variable must be one that the plant declares with `observe`.",
        R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  at 10 s observe valve = stuck;
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
})",
        R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  at 10 s observe valve.flow = no;
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
    CodeInfo{Code::scenario_not_a_command, "not a control variable",
             "`when command` waits for a command: a constraint over control variables of the plant. `at … command` "
             "sets one control variable.",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  when command valve = opened observe valve.flow = no;
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
})",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  when command valve.cmd = open observe valve.flow = no;
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
    CodeInfo{Code::scenario_after_end, "after the end of the scenario",
             "The event is later than the end of the scenario, so it never happens. Or the deadline of an expectation "
             "is later than the end, so the expectation is judged before its deadline.",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  duration 1 min;
  at 100 s fault valve = stuck;
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
})",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  duration 2 min;
  at 100 s fault valve = stuck;
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
    CodeInfo{Code::scenario_finer_than_cycle, "cycle out of range", "The executive's cycle is longer than 0.",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  cycle 0 s;
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
})",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca";
  cycle 0.5 s;
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
    CodeInfo{Code::scenario_without_truth, "no truth in a plant of rules",
             "With `rules only`, the rules of the scenario give all readings, and the plant has no modes. So no "
             "component can fail, and `truth` and `expect truth` refer to nothing.",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca" rules only;
  at 10 s fault valve = stuck;
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
})",
             R"(// test.scn
scenario "opens" {
  program "main.rmpl";
  plant "tap.tcca" rules only;
  at 10 s observe valve.flow = no;
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
};

}  // namespace

std::span<const CodeInfo> scenario_codes() { return scenario_table; }

}  // namespace rmpl::grammar
