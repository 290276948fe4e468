#!/usr/bin/env python3
# What a question about three components costs in plants of 1,000, 10,000 and 100,000 lines.
# SPDX-License-Identifier: MIT
"""Usage: slice.py TCCA-CHECK [ANOTHER-TCCA-CHECK]: a table of processor seconds, of each program."""

import pathlib
import resource
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
QUESTIONS = {
    "reached": "heater3 = hot & relay3 = opened & heater2 = hot",
    "never": "valve3 = open & relay3 = closed & heater3 = burnt",
}
LONGEST = 60  # seconds


def seconds(program, plant, never):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run([program, "safety", plant, "--never", never], check=False, timeout=LONGEST,
                              stdout=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return f"over {LONGEST} s"
    if done.returncode not in (0, 1):
        sys.exit(f"{program} gave no verdict: it ended with {done.returncode}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return f"{after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime:.2f} s"


def main():
    programs = sys.argv[1:]
    print("| plant | question |" + "".join(f" {'before' if i else 'now'} |" for i in range(len(programs))))
    print("| --- | --- |" + " ---: |" * len(programs))
    with tempfile.TemporaryDirectory() as folder:
        for kind in ("", "alike"):
            for lines in (1_000, 10_000, 100_000):
                plant = pathlib.Path(folder) / "plant.tcca"
                made = subprocess.run([HERE / "islands", str(lines), kind], check=True, capture_output=True)
                plant.write_bytes(made.stdout)
                for name, never in QUESTIONS.items():
                    told = " ".join(f"{seconds(p, plant, never)} |" for p in programs)
                    print(f"| {lines:,} lines{', like islands' if kind else ''} | {name} | {told}", flush=True)


main()
