#!/usr/bin/env python3
# What a long log of numbers costs: twenty channels of four pumps, read by monitors, in a table of a million rows.
# SPDX-License-Identifier: MIT
"""Usage: telemetry.py RMPL-RUN [ROWS [ANOTHER-RMPL-RUN]]      ROWS defaults to 1000000.

Prints processor seconds and peak memory of each program, and the digest of its output, which all have in common.
"""

import hashlib
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

RIG = pathlib.Path(__file__).resolve().parents[2] / "examples/telemetry"
PUMPS = 4


def plant():
    rig = (RIG / "pump.tcca").read_text(encoding="utf-8").replace("plant Rig {", "module Rig {")
    return rig + "\nplant Rigs {\n" + "".join(f"  r{r} : Rig;\n" for r in range(PUMPS)) + "}\n"


def monitors():
    rig = (RIG / "pump.mon").read_text(encoding="utf-8")
    return "".join(re.sub(r": (\w+\.\w+) {", rf": r{r}.\1 {{", re.sub(r'"([A-Z_]+)"( [-:r])', rf'"\1_{r}"\2', rig)) for r in range(PUMPS))


def table(rows, out):
    """A sample a second. The pumps run from the fourth second on; one filter clogs half way."""
    draw = random.Random(1)
    names = ["CONTACTOR", "FLOW", "P_IN", "P_OUT", "T_BEARING"]
    out.write("time," + ",".join(f"r{r}.pump.cmd," + ",".join(f"{name}_{r}" for name in names) for r in range(PUMPS)) + "\n")
    for row in range(rows):
        cells = [str(row)]
        for r in range(PUMPS):
            clogged = r == 2 and 2 * row > rows
            runs = row >= 4
            inlet = draw.gauss(0.2, 0.004)
            cells += ["start" if row == 2 else "", "ON" if row >= 2 else "OFF",
                      f"{draw.gauss(31 if clogged else 52, 0.5) if runs else 0.1:.1f}", f"{inlet:.3f}",
                      f"{inlet + ((0.7 if clogged else 0.25) if runs else 0) + draw.gauss(0, 0.004):.3f}", f"{draw.gauss(31, 0.03):.2f}"]
        out.write(",".join(cells) + "\n")


def cost(program, folder):
    """Processor seconds, mebibytes and the digest of one run."""
    digest = hashlib.sha256()
    command = [program, "estimate", folder / "rigs.tcca", "--log", folder / "log.csv", "--monitors", folder / "rigs.mon", "-q"]
    run = subprocess.Popen(command, stdout=subprocess.PIPE)
    while block := run.stdout.read(1 << 20):
        digest.update(block)
    _, status, used = os.wait4(run.pid, 0)
    run.returncode = os.waitstatus_to_exitcode(status)
    if run.returncode != 0:
        sys.exit(f"{program} ended with {run.returncode}")
    return f"{used.ru_utime:.2f} s, {used.ru_stime:.2f} s in the system, {used.ru_maxrss / 1024:.0f} MB, {digest.hexdigest()[:12]}"


def main():
    rows = int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "rigs.tcca").write_text(plant(), encoding="utf-8")
        (folder / "rigs.mon").write_text(monitors(), encoding="utf-8")
        with (folder / "log.csv").open("w", encoding="utf-8") as out:
            table(rows, out)
        print(f"{rows} rows of {5 * PUMPS} channels")
        for program in sys.argv[1:2] + sys.argv[3:]:
            print(f"{program}: {cost(program, folder)}", flush=True)


main()
