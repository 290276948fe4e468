#!/usr/bin/env python3
# What questions about programs cost: proofs with faults, tables of every fault, large plants of which little matters.
# SPDX-License-Identifier: MIT
"""Usage: depth.py TCCA-CHECK [ANOTHER-TCCA-CHECK]: a table of processor seconds, of each program."""

import pathlib
import resource
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLES = HERE.parent.parent / "examples"
LANDING = [EXAMPLES / "mars-edl/mars_edl.rmpl", EXAMPLES / "mars-edl/edl_lander.tcca"]
INSERTION = [EXAMPLES / "newmaap/orbit_insertion.rmpl", EXAMPLES / "newmaap/newmaap.tcca"]
LOST = "descent = touched & engine in { cold, heating, standby }"
HEAT = """Heat() :: {
  relay3 = closed;
  heater3 = hot;
  valve3 = open
}
"""
LONGEST = 120  # seconds


def seconds(program, question):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run([program, "program", *question], check=False, timeout=LONGEST, stdout=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return f"over {LONGEST} s"
    if done.returncode not in (0, 1):
        sys.exit(f"{program} gave no verdict: it ended with {done.returncode}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return f"{after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime:.2f} s"


def questions(folder):
    yield "EDL, every fault", [*LANDING, "--each-fault", "--finally", "descent = touched", "--never", LOST]
    for faults in (1, 2, 3):
        never = "chute = deployed & lander = connected"
        yield f"EDL, a proof, {faults} faults", [*LANDING, "--never", never, "--faults", str(faults)]
    for faults in (1, 2):
        yield f"EDL, all checks, {faults} faults", [*LANDING, "--faults", str(faults)]
    yield "NewMaap, every fault", [*INSERTION, "--each-fault"]
    program = folder / "heat.rmpl"
    program.write_text(HEAT)
    for lines in (1_000,):
        plant = folder / f"{lines}.tcca"
        plant.write_bytes(subprocess.run([HERE / "islands", str(lines)], check=True, capture_output=True).stdout)
        for faults in (0, 1, 2):
            never = ["--never", "valve3 = open & relay3 = opened", "--faults", str(faults)]
            yield f"islands, {lines:,} lines, a proof, {faults} faults", [program, plant, *never]


def main():
    programs = sys.argv[1:]
    print("| question |" + "".join(f" {'before' if i else 'now'} |" for i in range(len(programs))))
    print("| --- |" + " ---: |" * len(programs))
    with tempfile.TemporaryDirectory() as folder:
        for name, question in questions(pathlib.Path(folder)):
            print(f"| {name} | " + " ".join(f"{seconds(p, question)} |" for p in programs), flush=True)


main()
