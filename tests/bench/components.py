#!/usr/bin/env python3
# What an estimate of a plant of very many components costs: most of them independent of each other.
# SPDX-License-Identifier: MIT
"""Usage: components.py BIN_DIR [COMPONENTS [KIND...]]      COMPONENTS defaults to 100000, the kinds to all.

Estimates ten steps with `-k 1` and prints processor time and peak memory of each kind:
  commands  each component has a control
  readings  each has a sensor, and exits that take time
  both      each has a control and a sensor, most of which are used in each step
  shapes    the same, of fifty types
  pairs     the same, in pairs of a source and what it feeds
"""

import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

MODES = """  initial off;
  mode off {{ {off} }};
  mode on {{ {on} }};
  fault dead {{ {off} }};
"""
STEPS = """  off -> on {to_on};
  on -> off {to_off};
  any -> dead with {dead:.9f};
"""
KINDS = ("commands", "readings", "both", "shapes", "pairs")


def component(name, controlled, seen, fed, dead):
    light = ("light = dark", "light = bright") if seen else ("", "")
    text = f"component {name} {{\n"
    text += "  input cmd : { none, on, off };\n" if controlled else ""
    text += "  input feed : { yes, no };\n" if fed else ""
    text += "  output light : { bright, dark };\n" if seen else ""
    text += MODES.format(off=light[0], on=light[1]).replace(" {  }", "")
    to_on = "when cmd = on" + (" & feed = yes" if fed else "") if controlled else "in [1 s, 20 s] ~ exponential(10 s)"
    return text + STEPS.format(to_on=to_on, to_off="when cmd = off" if controlled else "in [1 s, 20 s]", dead=dead) + "}\n"


def write_plant(path, count, kind):
    """The controls and observables, too."""
    types = 50 if kind == "shapes" else 1
    controls, observed = [], []
    with open(path, "w", encoding="utf-8") as out:
        for t in range(types):
            out.write(component(f"Unit{t}", kind != "readings", kind != "commands", kind == "pairs", 0.001 * (1 + t) / types))
        if kind == "pairs":
            source = component("Source", True, True, False, 0.001)
            out.write(source.replace("light", "feed").replace("bright", "yes").replace("dark", "no"))
        out.write("plant Many {\n")
        for i in range(count // 2 if kind == "pairs" else count):
            out.write(f"  u{i} : Unit{i % types};\n")
            if kind == "pairs":
                out.write(f"  s{i} : Source;\n  s{i}.feed = u{i}.feed;\n  control s{i}.cmd default none;\n")
                controls.append(f"s{i}.cmd")
            if kind != "readings":
                out.write(f"  control u{i}.cmd default none;\n")
                controls.append(f"u{i}.cmd")
            if kind != "commands":
                out.write(f"  observe u{i}.light;\n")
                observed.append(f"u{i}.light")
        out.write("}\n")
    return controls, observed


def write_log(path, controls, observed):
    draw = random.Random(7)
    lit = dict.fromkeys(observed, "dark")
    with open(path, "w", encoding="utf-8") as out:
        for step in range(1, 11):
            command = {control: draw.choice(["on", "off"]) for control in controls if draw.random() < 0.3}
            for light in observed:
                told = command.get(light.split(".")[0] + ".cmd")
                if told and draw.random() < 0.97:
                    lit[light] = "bright" if told == "on" else "dark"
                elif draw.random() < 0.01:
                    lit[light] = "dark"
            seen = {light: state for light, state in lit.items() if draw.random() < 0.9}
            out.write(json.dumps({"time": step, "command": command, "observations": seen}) + "\n")


def main():
    program = pathlib.Path(sys.argv[1]).resolve() / "rmpl-run"
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 100_000
    for kind in sys.argv[3:] or KINDS:
        with tempfile.TemporaryDirectory() as folder:
            plant, log = pathlib.Path(folder) / "many.tcca", pathlib.Path(folder) / "log.jsonl"
            write_log(log, *write_plant(plant, count, kind))
            run = subprocess.Popen([program, "estimate", plant, "--log", log, "-k", "1", "-q"], stdout=subprocess.DEVNULL)
            _, status, used = os.wait4(run.pid, 0)
            run.returncode = os.waitstatus_to_exitcode(status)
            if run.returncode != 0:
                sys.exit(f"{program} ended with {run.returncode}")
            print(f"{kind:9} {used.ru_utime:6.2f} s, {used.ru_stime:.2f} s in the system, {used.ru_maxrss / 1024:.0f} MB", flush=True)


main()
