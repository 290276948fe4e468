#!/usr/bin/env python3
# What the plan of one command costs in plants of 1,000, 5,000 and 10,000 components, set-up and all.
# SPDX-License-Identifier: MIT
"""Usage: planning.py RMPL-RUN [ANOTHER-RMPL-RUN]: a table of processor seconds and peak memory, of each program."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
LINES_AN_ISLAND = 60  # of four components
PLANTS = {
    "islands": (lambda count: [HERE / "islands", str(count // 4 * LINES_AN_ISLAND)], "valve7.flow = full"),
    "tree on one bus": (lambda count: [HERE / "bus_tree", str(count)], "valve27.flow = on"),
}
LONGEST = 120  # processor seconds
STOPPED = {124, 128 + signal.SIGXCPU, 128 + signal.SIGKILL, -signal.SIGXCPU, -signal.SIGKILL}  # for having taken longer


def cost(program, plant, goal):
    """Processor seconds and mebibytes of one plan."""
    plan = subprocess.Popen(["timeout", str(2 * LONGEST), "prlimit", f"--cpu={LONGEST}", program, "plan", plant, "--goal", goal],
                            stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(plan.pid, 0)
    plan.returncode = os.waitstatus_to_exitcode(status)
    if plan.returncode in STOPPED:
        return f"over {LONGEST} s | |"
    if plan.returncode != 0:
        sys.exit(f"{program} ended with {plan.returncode}")
    return f"{used.ru_utime + used.ru_stime:.2f} s | {used.ru_maxrss / 1024:.0f} MB |"


def main():
    programs = sys.argv[1:]
    print("| plant | components |" + "".join(f" {'before' if i else 'now'} | memory |" for i in range(len(programs))))
    print("| --- | ---: |" + " ---: | ---: |" * len(programs))
    with tempfile.TemporaryDirectory() as folder:
        plant = pathlib.Path(folder) / "plant.tcca"
        for name, (make, goal) in PLANTS.items():
            for count in (1_000, 5_000, 10_000):
                plant.write_bytes(subprocess.run(make(count), check=True, capture_output=True).stdout)
                told = " ".join(cost(p, plant, goal) for p in programs)
                print(f"| {name} | {count:,} | {told}", flush=True)


main()
