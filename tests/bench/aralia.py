#!/usr/bin/env python3
# Static fault trees of the Aralia collection beside SCRAM, in one run.
# SPDX-License-Identifier: MIT
"""Usage: aralia.py BIN_DIR TREES [--seconds N] [NAME...]

TREES is the folder data/openpsa of github.com/openpra-org/aralia-fault-tree-dataset. Each tree becomes a plant by `rmplc import`.
Prints a row a tree: processor seconds of `tcca-check fault-tree --list 0` and of `scram --bdd`, the best of three, or `-` past N
seconds (default 5); the number of minimal cut sets, and the probability. Exits 1 where the two differ.
"""

import argparse
import json
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

CLOSE = 1e-5  # SCRAM prints six digits


def timed(command, seconds):
    """Processor seconds and output; nothing where it takes too long."""
    best, output = None, ""
    for _ in range(3):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        done = subprocess.run(command, capture_output=True, text=True, preexec_fn=limit, check=False)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode < 0:
            return None, ""
        spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        best, output = min(spent, best or spent), done.stdout
        if best > 1:
            break
    return best, output


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("bin_dir", type=pathlib.Path)
    arguments.add_argument("trees", type=pathlib.Path)
    arguments.add_argument("--seconds", type=int, default=5)
    arguments.add_argument("names", nargs="*")
    options = arguments.parse_args()
    differ = False
    for tree in sorted(options.trees.glob("*.xml")):
        if options.names and tree.stem not in options.names:
            continue
        with tempfile.TemporaryDirectory() as folder:
            plant = pathlib.Path(folder) / "tree.tcca"
            subprocess.run([options.bin_dir / "rmplc", "import", tree, "-o", plant], check=True)
            top = re.search(r"top event is: (.*)", plant.read_text(encoding="utf-8"))[1]
            ours, answer = timed([options.bin_dir / "tcca-check", "fault-tree", plant, "--top", top, "--within", "1",
                                  "--list", "0", "--format", "json"], options.seconds)
        theirs, report = timed(["scram", "--bdd", "--probability", "true", tree], options.seconds)
        told = json.loads(answer) if answer else None
        found = re.search(r'<sum-of-products [^>]*products="(\d+)"[^>]*probability="([^"]*)"', report)
        figures = f"{told['count']:.0f} sets, {told['probability']['upper']:.6g}" if told else ""
        times = [f"{seconds:.3f}" if seconds is not None else "-" for seconds in (ours, theirs)]
        print(f"{tree.stem}: ours {times[0]} s, scram {times[1]} s; {figures}", flush=True)
        if told and found:
            sets, probability = int(found[1]), float(found[2])
            same = sets == told["count"] and abs(probability - told["probability"]["upper"]) <= CLOSE * probability
            if not same:
                print(f"  scram: {sets} sets, {probability}")
            differ = differ or not same
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
