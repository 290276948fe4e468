#!/usr/bin/env python3
# Faults planted one by one in a flight without any, program, scenario and properties: lint finds each, and is silent
# where what looks like one is none.
# SPDX-License-Identifier: MIT
"""lint_flights.py RMPLC: lints a clean flight, then one for each edit of the lists below."""

import sys

import lint_planted

FLIGHT = {
    "tap.tcca": """\
domain Flow = { none, low, high };

component Tap {
  input  cmd  : { none, open, close };
  output flow : Flow;
  initial closed;
  mode  closed { flow = none };
  mode  open   { flow = high };
  fault leaky  { flow = low };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
  leaky  -> closed when cmd = close;
  any nominal -> leaky with rate 1e-5 /h;
}

component Pump {
  input  cmd   : { none, on, off };
  output power : { zero, nominal };
  initial off;
  mode off { power = zero };
  mode on  { power = nominal };
  off -> on  when cmd = on;
  on  -> off when cmd = off;
}

plant Sink {
  tap  : Tap;
  pump : Pump;
  control tap.cmd default none;
  control pump.cmd default none;
  observe tap.flow, pump.power;
}
""",
    "main.rmpl": """\
Main() :: {
  clock t;
  pump = on;
  t = 0;
  do always tap = open watching (t >= 5 s);
  when (t >= 10 s) donext Stop(pump);
  { tap = closed, unless tap.flow = high thennext pump = off }
}

Stop(device) :: {
  device = off
}
""",
    "test.scn": """\
scenario "fill" {
  program "main.rmpl";
  plant "tap.tcca";
  cycle 500 ms;
  duration 60 s;
  at 2 s observe tap.flow = low for 1 s;
  when command tap.cmd = close observe tap.flow = none for 2 s;
  expect tap = closed within 30 s;
}
""",
    "tap.props": """\
property "leaks" { reach tap = leaky; faults 1; }
property "shuts" { after tap = leaky within 5 s tap = closed; faults 1; expect violated; }
""",
}

STUCK = ("  fault leaky  { flow = low };", "  fault leaky  { flow = low };\n  mode  ajar   { flow = low };")

# What is planted, the code that must be found, and the edits: a text that stands once in the flight, and what comes in
# its place.
SEEDED = [
    ("a transition given twice", 500, ("  leaky  -> closed when cmd = close;", "  leaky  -> closed when cmd = close;\n  leaky  -> closed when cmd = close;")),
    ("a wait for two modes at once", 501, ("when (t >= 10 s) donext", "when pump = on & pump = off donext")),
    ("a wait for what the interconnections exclude", 501, ("when (t >= 10 s) donext", "when tap = open & tap.flow = none donext")),
    ("a watch for what a constraint excludes", 501, ("watching (t >= 5 s)", "watching pump = on & pump.power = zero")),
    ("a condition that every state satisfies", 502, ("unless tap.flow = high", "unless tap.flow in { none, low, high }")),
    ("a condition that the modes entail", 502, ("unless tap.flow = high", "unless (tap = open -> tap.flow = high)")),
    ("a wait for a mode that nothing leads to", 503, STUCK, ("when (t >= 10 s) donext", "when tap = ajar donext")),
    ("goals for two modes at once", 504, ("  pump = on;\n", "  { pump = on, pump = off };\n")),
    ("a thread that asks for the contrary later", 504, ("  do always tap = open watching (t >= 5 s);", "  { always pump = on, when tap = open donext pump = off };")),
    ("a step behind one that never ends", 505, ("  do always tap = open watching (t >= 5 s);", "  always tap = open;")),
    ("a step behind a definition that never ends", 505, ("device = off", "always device = off")),
    ("a goal on a fault", 506, ("{ tap = closed,", "{ tap = leaky,")),
    ("a goal that nothing takes back", 507, ("  on  -> off when cmd = off;\n", ""), ("Stop(pump)", "Stop(tap)"), ("pump = off }", "tap = open }"), ("device = off", "device = closed")),
    ("a clock that is started again as it runs", 508, ("  do always tap", "  t = 0;\n  do always tap")),
    ("a definition that nothing calls", 509, ("Stop(device) ::", "Halt(device) :: { device = off; when device.power = nominal donext Halt(device) }\nStop(device) ::"), ('  program "main.rmpl";', '  program "main.rmpl" main Main;')),
    ("a parameter that is never used", 510, ("  device = off", "  pump = off")),
    ("a clock that is never read", 511, ("  pump = on;\n", "  u = 0;\n  pump = on;\n")),
    ("a clock that is declared and never read", 511, ("  clock t;", "  clock t, u;")),
    ("a domain that no variable has", 512, ("domain Flow", "domain Level = { empty, full };\ndomain Flow")),
    ("a component without an instance", 513, ("plant Sink", "component Drain {\n  initial still;\n  mode still;\n}\n\nplant Sink")),
    ("`,` and `;` in one pair of braces", 514, ("  { tap = closed, unless tap.flow = high thennext pump = off }", "  tap = closed, pump = off")),
    ("a reading that is over before it is looked at", 515, ("for 1 s", "for 100 ms")),
    ("an expectation within less than a cycle", 515, ("within 30 s", "within 200 ms")),
    ("a clock that is compared within the first cycle", 515, ("(t >= 10 s)", "(t >= 10 ms)")),
    ("a transition that is over within a cycle", 515, ("when cmd = on;", "when cmd = on in [0 s, 100 ms];")),
    ("a property that the constraints decide", 516, ("reach tap = leaky", "reach tap = leaky -> tap.flow = low")),
    ("a response to what cannot be", 516, ("after tap = leaky within", "after tap = leaky & tap.flow = high within")),
    ("a response to a fault without faults", 516, ("tap = closed; faults 1;", "tap = closed; faults 0;")),
    ("an expectation that never fails", 520, ("expect tap = closed within 30 s;", "expect never tap = closed & tap = open;")),
    ("an expectation of what cannot be", 520, ("expect tap = closed within 30 s;", "expect pump = on & pump.power = zero within 30 s;")),
    ("an expectation that holds in every state", 520, ("expect tap = closed within 30 s;", "expect pump = on -> pump.power = nominal within 30 s;")),
    ("an expectation after what the plant never gets to", 520, STUCK, ("expect tap = closed within 30 s;", "expect tap = closed within 30 s after tap = ajar;")),
    ("an end that cannot be as it is expected", 520, ("expect tap = closed within 30 s;", "expect finished with tap = open & tap.flow = low;")),
    ("a deadline behind the end", 405, ("within 30 s", "within 2 min")),
    ("a rule for what never is", 517, ("when command tap.cmd = close", "when estimate tap = open & tap = closed")),
    ("an allowance that allows nothing", 518, ("  t = 0;", "  t = 0;  // lint: allow RMPL0511 because it is read elsewhere")),
    ("an allowance without a reason", 519, ("  t = 0;", "  t = 0;  // lint: allow RMPL0511")),
]

# What is none.
CLEAN = [
    ("the flight as it is",),
    ("a transition between the same modes with another guard", ("  leaky  -> closed when cmd = close;", "  leaky  -> closed when cmd = close;\n  closed -> open   when cmd = open & flow = none;")),
    ("a wait for a fault", ("when (t >= 10 s) donext", "when tap = leaky donext")),
    ("goals for one mode in two threads", ("  pump = on;\n", "  { pump = on, pump = on };\n")),
    ("the contrary after the end of the thread that asked", ("watching (t >= 5 s);", "watching (t >= 5 s);\n  do always tap = closed watching (t >= 6 s);")),
    ("a step behind one that a watch ends", ("device = off", "do always device = off watching pump.power = zero")),
    ("a clock that is started again when what has it starts again", ("  clock t;", "  clock t;\n  Wait();"), ("Stop(device) ::", "Wait() :: { clock w; w = 0; when (w >= 1 s) donext pump = on }\nStop(device) ::")),
    ("a parameter that is only passed on", ("donext Stop(pump)", "donext Hand(pump)"), ("Stop(device) ::", "Hand(device) :: { Stop(device) }\nStop(device) ::")),
    ("a reading for just a cycle", ("for 1 s", "for 500 ms")),
    ("a response to a fault with one", ("after tap = leaky within 5 s", "after tap = leaky within 9 s")),
    ("an expectation that only time can break", ("expect tap = closed within 30 s;", "expect never tap = leaky & pump = off;")),
    ("every state is as expected, but after something", ("expect tap = closed within 30 s;", "expect tap.flow in { none, low, high } after tap = open;")),
    ("a deadline at the end", ("within 30 s", "within 60 s")),
    ("a rule for a command that is given", ("tap.cmd = close observe", "tap.cmd in { open, close } observe")),
]


if __name__ == "__main__":
    sys.exit(lint_planted.main(FLIGHT, ["test.scn", "tap.props"], SEEDED, CLEAN))
