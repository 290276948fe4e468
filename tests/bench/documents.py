#!/usr/bin/env python3
# What a compiled document takes beside its source: bytes, and the time and memory to compile, to write and to load.
# SPDX-License-Identifier: MIT
"""Usage: documents.py BIN_DIR [LINES...]: a table, by default of plants of 1,000 to 1,000,000 lines.

Loading is `tcca-check safety` with a question of one component, of which the plant is nearly all the work.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def cost(*command):
    """Processor seconds and mebibytes of a run."""
    with open(os.devnull, "wb") as nothing:
        run = subprocess.Popen(command, stdout=nothing)
        _, status, used = os.wait4(run.pid, 0)
    run.returncode = os.waitstatus_to_exitcode(status)
    assert run.returncode == 0, command
    return f"{used.ru_utime + used.ru_stime:.2f} s, {used.ru_maxrss / 1024:.0f} MB"


def main():
    programs = pathlib.Path(sys.argv[1]).resolve()
    sizes = [int(lines) for lines in sys.argv[2:]] or [1_000, 10_000, 100_000, 1_000_000]
    print("| plant | source | document | times | compiled | source loaded | document loaded |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    with tempfile.TemporaryDirectory() as folder:
        source, document = pathlib.Path(folder) / "plant.tcca", pathlib.Path(folder) / "plant.json"
        for kind in ("", "alike"):
            for lines in sizes:
                if kind and lines > 400_000:
                    continue  # beyond the limit of a plant
                source.write_bytes(subprocess.run([HERE / "islands", str(lines), kind], check=True, capture_output=True).stdout)
                compiled = cost(programs / "rmplc", "compile", source, "-o", document)
                loaded = [cost(programs / "tcca-check", "safety", plant, "--never", "bus0 = up & bus0 = dead")
                          for plant in (source, document)]
                before, after = source.stat().st_size, document.stat().st_size
                print(f"| {lines:,} lines{', like islands' if kind else ''} | {before / 1e6:.2f} MB | {after / 1e6:.2f} MB | "
                      f"{after / before:.1f} | {compiled} | {loaded[0]} | {loaded[1]} |", flush=True)


main()
