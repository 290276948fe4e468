#!/usr/bin/env python3
# Faults planted one by one in a plant without any: lint finds each, and is silent where what looks like one is none.
# SPDX-License-Identifier: MIT
"""lint_seeded.py RMPLC: lints a clean plant, then one for each edit of the lists below."""

import sys

import lint_planted

PLANT = """\
domain Pressure = { low, high };

component Tank {
  output outlet, gauge : Pressure;
  initial full;
  mode  full  { outlet = high & gauge = high };
  fault empty { outlet = low & gauge = low };
  full -> empty with rate 1e-5 /h;
}

component Driver {
  input  cmd    : { none, on, off, open, close };
  output out    : { none, open, close };
  output status : { off, on, tripped };
  initial off;
  mode  off     { out = none & status = off };
  mode  on      { (out = open <-> cmd = open) & (out = close <-> cmd = close) & status = on };
  fault tripped { out = none & status = tripped };
  off     -> on      when cmd = on;
  on      -> off     when cmd = off;
  tripped -> off     when cmd = off;
  on      -> tripped with rate 1e-4 /h;
}

component Valve {
  input  cmd    : { none, open, close };
  input  inlet  : Pressure;
  output outlet : Pressure;
  output switch : { shut, wide };
  initial closed;
  mode  closed { outlet = low & switch = shut };
  mode  open   { outlet = inlet & switch = wide };
  fault stuck  { outlet = low & switch = wide };
  closed -> open   when cmd = open;
  open   -> closed when cmd = close;
  closed -> stuck  when cmd = open with 0.001;
}

component Heater {
  input  cmd   : { none, on, off };
  output temp  : { cold, warm };
  output power : { zero, nominal };
  initial off;
  mode  off     { temp = cold & power = zero };
  mode  heating { temp = cold & power = nominal };
  mode  hot     { temp = warm & power = nominal };
  fault broken  { temp = cold & power = zero };
  off     -> heating when cmd = on;
  heating -> off     when cmd = off;
  heating -> hot     when cmd != off in [30 s, 60 s];
  hot     -> off     when cmd = off;
  any nominal -> broken with rate 1e-5 /h;
}

plant Feed {
  tank   : Tank;
  driver : Driver;
  valve  : Valve;
  heater : Heater;

  tank.outlet = valve.inlet;
  driver.out = valve.cmd;

  control driver.cmd default none;
  control heater.cmd default none;
  observe tank.gauge, driver.status, valve.switch, valve.outlet, heater.temp, heater.power;
}
"""

ARMS = """\
component Arm {
  output place : { inside, outside };
  initial stowed;
  mode stowed   { place = inside };
  mode deployed { place = outside };
  stowed -> deployed in [10 s, 20 s];
}
"""

# Lit some time after there is power, which there is not at the start.
LAMP = [
    ("plant Feed {", """\
component Lamp {
  input  power : { zero, nominal };
  output lit   : { no, yes };
  initial dark;
  mode dark   { lit = no };
  mode bright { lit = yes };
  dark   -> bright when power = nominal in [2 s, 4 s];
  bright -> dark   when power = zero;
}

plant Feed {
  lamp   : Lamp;
  lamp.power = heater.power;
  observe lamp.lit;
"""),
]

# What is wrong, the codes one of which tells of it, and the edits: a text and what stands in its place.
SEEDED = [
    ("the way into a mode is forgotten", 530, ("  closed -> open   when cmd = open;\n", "")),
    ("the way into a mode goes elsewhere", 530, ("heating -> hot     when", "heating -> off     when")),
    ("a mode has exits only", 530, ("  closed -> open ", "  mode  purging { switch = shut };\n  purging -> closed;\n  closed -> open ")),
    ("a fault that nothing leads to", 530, ("  full -> empty", "  fault leaking { outlet = low };\n  full -> empty")),
    ("a fault whose rate is zero", 530, ("rate 1e-5 /h;\n}\n\ncomponent Driver", "rate 0 /h;\n}\n\ncomponent Driver")),
    ("two modes that lead to each other only", 530, ("  closed -> open ", "  mode  left { switch = shut };\n  mode  right { switch = wide };\n  left -> right when cmd = open;\n  right -> left when cmd = close;\n  closed -> open ")),
    ("a guard that contradicts itself", 531, ("open   -> closed when cmd = close;", "open   -> closed when cmd = close & cmd = open;")),
    ("a guard that contradicts its mode", 531, ("open   -> closed when cmd = close;", "open   -> closed when cmd = close & switch = shut;")),
    ("a guard that contradicts the interconnections", 531, ("driver.out = valve.cmd;", "driver.out = none <-> valve.cmd = none;\n  valve.cmd != close;")),
    ("a guard on what a fault alone would bring, and there is none", 531, ("open   -> closed when cmd = close;", "open   -> closed when cmd = close & inlet = low;"), ("  fault empty { outlet = low & gauge = low };\n  full -> empty with rate 1e-5 /h;\n", "")),
    ("a guard that nothing implies", 531, ("mode  on      { (out = open <-> cmd = open) & (out = close <-> cmd = close) & status = on }", "mode  on      { status = on }")),
    ("a mode that an interconnection excludes", 532, ("  control driver", "  valve.switch = shut;\n  control driver")),
    ("a mode that contradicts itself", 532, ("mode  hot     { temp = warm &", "mode  hot     { temp = warm & temp = cold &")),
    ("a mode that the only mode of another excludes", 532, ("  fault empty { outlet = low & gauge = low };\n  full -> empty with rate 1e-5 /h;\n", ""), ("{ outlet = inlet & switch = wide }", "{ outlet = inlet & inlet = low & switch = wide }")),
    ("guards that share an idle command", 533, ("heating -> off     when cmd = off;", "heating -> off     when cmd != on;"), ("when cmd != off in [30 s, 60 s];", "when cmd != off;")),
    ("guards that share a command of a set", 533, ("hot     -> off     when cmd = off;", "hot     -> off     when cmd in { off, none };\n  hot     -> heating when cmd in { none, on };")),
    ("guards on different attributes", 533, ("open   -> closed when cmd = close;", "open   -> closed when cmd = close;\n  open   -> ajar when inlet = low;\n  ajar -> closed when cmd = close;"), ("{ shut, wide }", "{ shut, wide, between }"), ("  fault stuck ", "  mode  ajar { switch = between };\n  fault stuck ")),
    ("staying beside going", 533, ("hot     -> off     when cmd = off;", "hot     -> off     when cmd = off;\n  hot     -> hot     when cmd != on;")),
    ("an untimed transition beside a timed one", 534, ("heating -> hot     when cmd != off in [30 s, 60 s];", "heating -> hot     when cmd != off in [30 s, 60 s];\n  heating -> hot     when cmd != off;")),
    ("a fault that is certain", 534, ("closed -> stuck  when cmd = open with 0.001;", "closed -> stuck  when cmd = open with 1;")),
    ("faults that are certain together", 534, ("closed -> stuck  when cmd = open with 0.001;", "closed -> stuck  when cmd = open with 0.5;\n  closed -> jammed when cmd = open with 0.5;"), ("  fault stuck ", "  fault jammed { outlet = low & switch = shut };\n  fault stuck ")),
    ("a transition without a guard beside a timed one", 534, ("heating -> off     when cmd = off;", "heating -> off;")),
    ("an initial mode that an interconnection excludes", 535, ("  initial closed;", "  initial open;"), ("  control driver", "  driver = off -> valve.switch = shut;\n  control driver")),
    ("an initial mode of an instance that another excludes", 535, ("  valve  : Valve;", "  valve  : Valve { initial open; };"), ("  control driver", "  heater = off -> valve = closed;\n  control driver")),
    ("one of two initial modes that is excluded", 536, ("  initial closed;", "  initial closed 0.5, open 0.5;"), ("  control driver", "  driver = off -> valve.switch = shut;\n  control driver")),
    ("two that time forces into modes that exclude each other", 537, ("plant Feed {", ARMS + "plant Feed {\n  left, right : Arm;\n  left.place = inside | right.place = inside;\n  observe left.place, right.place;\n")),
    ("one that is forced where another may not be", 537, ("plant Feed {", ARMS + "plant Feed {\n  left : Arm;\n  right : Arm { initial deployed; };\n  !(left = deployed & right = deployed);\n  observe left.place, right.place;\n")),
    ("interconnections that contradict each other", 538, ("  control driver", "  valve.switch = shut;\n  valve.switch = wide;\n  control driver")),
    ("interconnections that go round", 538, ("  control driver", "  valve.outlet = low <-> valve.inlet = high;\n  valve.outlet = valve.inlet;\n  control driver")),
    ("a command that is excluded", 539, ("  control driver", "  heater.cmd != on;\n  control driver")),
    ("a component that waits for one that nobody commands", 540, ("  control heater.cmd default none;", "  clock : Timer;\n  clock.due = yes <-> heater.cmd = on;\n  clock.due = no <-> heater.cmd = off;\n  observe clock.due;"), ("plant Feed {", "component Timer {\n  output due : { no, yes };\n  initial waiting;\n  mode waiting { due = no };\n  mode done { due = yes };\n  waiting -> done in [5 s, 9 s];\n}\nplant Feed {")),
    ("a component that is not observed", 541, (", heater.temp, heater.power", "")),
    ("a fault with the constraint of the nominal mode", 541, ("fault empty { outlet = low & gauge = low }", "fault empty { outlet = high & gauge = high }")),
    ("a fault that is there twice", 542, ("  fault stuck ", "  fault jammed { outlet = low & switch = wide };\n  closed -> jammed when cmd = open with 0.001;\n  fault stuck ")),
    ("faults that differ in what is not observed", 542, ("  fault broken  { temp = cold & power = zero };", "  fault broken  { temp = cold & power = zero };\n  fault shorted { temp = warm & power = zero };\n  any nominal -> shorted with rate 1e-5 /h;"), (", heater.temp, heater.power", ", heater.power")),
    ("a sensor is not observed", 543, (", heater.temp, heater.power", ", heater.power")),
    ("a sensor that reads the same in two modes", 543, ("mode  hot     { temp = warm &", "mode  hot     { temp = cold &")),
    ("an input that is not connected", 544, ("  driver.out = valve.cmd;\n", "")),
    ("an input that is not commanded", 544, ("  control heater.cmd default none;\n", "")),
    ("inputs that are connected to each other only", 544, ("  tank.outlet = valve.inlet;\n", "  spare : Valve;\n  spare.inlet = valve.inlet;\n  spare.cmd = none;\n")),
    ("a command value too many", 545, ("{ none, on, off };\n  output temp", "{ none, on, off, boost };\n  output temp")),
    ("a transition that reads the wrong value", 545, ("hot     -> off     when cmd = off;", "hot     -> off     when cmd = on;"), ("heating -> off     when cmd = off;\n", ""), ("when cmd != off in", "when cmd = on in")),
    ("an attribute that nothing mentions", 546, ("  output temp  :", "  output drain : { no, yes };\n  output temp  :")),
    ("an input that its component does not read", 546, ("  output temp  :", "  input  feed  : Pressure;\n  output temp  :"), ("  control driver", "  heater.feed = tank.gauge;\n  control driver")),
    ("a transition that is given twice", 500, ("hot     -> off     when cmd = off;", "hot     -> off     when cmd = off;\n  hot     -> off     when cmd = off;")),
    ("a default that a mode excludes", 539, ("  control driver", "  valve.switch = shut -> heater.cmd != none;\n  control driver")),
    ("weights of transitions that take time", 550, ("heating -> hot     when cmd != off in [30 s, 60 s];", "heating -> hot     when cmd != off in [30 s, 60 s] with 0.9;\n  heating -> off     when cmd != off in [30 s, 60 s] with 0.1;")),
    ("a self-transition beside what takes time", 552, ("heating -> off     when cmd = off;", "heating -> off     when cmd = off;\n  heating -> heating when cmd = on;")),
    ("a weight of a transition that is alone", 550, ("closed -> open   when cmd = open;", "closed -> open   when cmd = open with 0.9;")),
    ("a transition that is to restart a clock", 548, ("heating -> off     when cmd = off;", "heating -> off     when cmd = off;\n  heating -> heating when cmd = off in [1 s, 2 s];"), ("when cmd != off in [30 s, 60 s];", "when cmd = on in [30 s, 60 s];"), ("  heating -> off     when cmd = off;\n", "")),
    ("a transition that says what stays so", 548, ("closed -> open   when cmd = open;", "closed -> open   when cmd = open;\n  closed -> closed when cmd = close;")),
    ("a delay from a command", 551, ("closed -> open   when cmd = open;", "closed -> open   when cmd = open in [2 s, 3 s];")),
    ("a delay from what another component brings about", 551, *LAMP),
    ("a plant without sensors", 549, ("  observe tank.gauge, driver.status, valve.switch, valve.outlet, heater.temp, heater.power;\n", "")),
    ("a fault among the outcomes of a transition that takes time", 547, ("heating -> hot     when cmd != off in [30 s, 60 s];", "heating -> { hot with 0.9, broken with 0.1 } when cmd != off in [30 s, 60 s];")),
]

# What looks like a fault, and is none.
CLEAN = [
    ("the plant as it is",),
    ("a mode that only an instance starts in", ("  closed -> open   when cmd = open;\n", ""), ("  closed -> stuck  when cmd = open", "  open -> stuck  when cmd = open"), ("  valve  : Valve;", "  valve  : Valve { initial open; };")),
    ("a guard that holds in a fault mode of another only", ("open   -> closed when cmd = close;", "open   -> closed when cmd = close;\n  open   -> closed when cmd = none & inlet = low;")),
    ("overlapping guards with weights", ("hot     -> off     when cmd = off;", "hot     -> off     when cmd = off with 0.9;\n  hot     -> heating when cmd = off with 0.1;")),
    ("overlapping guards to one mode", ("hot     -> off     when cmd = off;", "hot     -> off     when cmd = off;\n  hot     -> off     when cmd != on;")),
    ("guards that only the interconnections keep apart", ("open   -> closed when cmd = close;", "open   -> closed when cmd = close;\n  open   -> ajar when inlet = low & cmd = none;\n  ajar -> closed when cmd = close;"), ("{ shut, wide }", "{ shut, wide, between }"), ("  fault stuck ", "  mode  ajar { switch = between };\n  fault stuck ")),
    ("timed transitions that compete", ("hot     -> off     when cmd = off;", "hot     -> off     when cmd = off;\n  hot     -> heating in [1 h, 2 h];\n  hot     -> off     in [1 h, 3 h];")),
    ("an untimed transition that goes first at times", ("heating -> off     when cmd = off;", "heating -> off     when cmd in { none, off };")),
    ("a fault that is nearly certain", ("closed -> stuck  when cmd = open with 0.001;", "closed -> stuck  when cmd = open with 0.999;")),
    ("initial modes that depend on each other", ("  initial closed;", "  initial closed 0.5, open 0.5;"), ("  control driver", "  heater = off -> (valve = closed | valve = open | valve = stuck);\n  control driver")),
    ("two that time forces one after the other", ("plant Feed {", ARMS + "plant Feed {\n  left, right : Arm;\n  observe left.place, right.place;\n")),
    ("an input that a constant drives", ("  tank.outlet = valve.inlet;\n", "  valve.inlet = high;\n")),
    ("an input that is observed only", ("  output temp  :", "  input  feed  : Pressure;\n  output temp  :"), ("observe tank.gauge,", "observe heater.feed, tank.gauge,")),
    ("a fault that looks like one nominal mode of two", ("fault stuck  { outlet = low & switch = wide }", "fault stuck  { outlet = low & switch = shut }")),
    ("faults that look alike, but one can be left", ("  fault broken  { temp = cold & power = zero };", "  fault broken  { temp = cold & power = zero };\n  fault blown   { temp = cold & power = zero };\n  any nominal -> blown with rate 1e-5 /h;\n  blown -> off when cmd = off;")),
    ("a delay from what is there at the start", *LAMP, ("  heater : Heater;", "  heater : Heater { initial hot; };")),
    ("a command that only a constraint reads", ("{ none, on, off, open, close };\n  output out", "{ none, on, off, open, close, test };\n  output out"), ("{ off, on, tripped }", "{ off, on, tripped, testing }"), ("& status = on }", "& (cmd = test <-> status = testing) & status in { on, testing } }")),
]


if __name__ == "__main__":
    sys.exit(lint_planted.main({"feed.tcca": PLANT}, ["feed.tcca"], SEEDED, CLEAN))
