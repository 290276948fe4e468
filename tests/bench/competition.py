#!/usr/bin/env python3
"""Times rmpl-run diagnose on the diagnostic competition's scenarios, and compares with the published sets.

SPDX-License-Identifier: MIT

usage: competition.py PROGRAMS DXC [--seconds 60] [CIRCUIT…]

PROGRAMS is the folder of rmplc and rmpl-run, DXC the folder with models/ and dxc26/ (see docs/benchmarks.md). Each
scenario is one whole process: read the model, minimise, and count the complete set of minimum-cardinality diagnoses.
Where a set was published it is listed and compared.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time


def published(text):
    """The published set, or None; with the faults of each of its diagnoses as a frozenset."""
    group = re.search(r"ambiguityGroup.*?diagnoses\s*=\s*\{(.*)\}\s*;", text, re.S)
    if not group:
        return None
    found = {frozenset(re.findall(r"\w+", one)) for one in re.findall(r"\{([^{}]*)\}", group.group(1))}
    return found or None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("dxc", type=pathlib.Path)
    parser.add_argument("circuits", nargs="*")
    parser.add_argument("--seconds", type=float, default=60)
    options = parser.parse_args()
    scratch = pathlib.Path(tempfile.mkdtemp())
    circuits = options.circuits or sorted(p.name for p in (options.dxc / "dxc26").iterdir() if p.is_dir())
    print("| circuit | scenarios | in 1 s | in %g s | largest set | median ms | worst ms | published | equal | ours smaller "
          "| ours larger |" % options.seconds)
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    differences = []
    for circuit in circuits:
        model = scratch / (circuit + ".tcca")
        subprocess.run([options.programs / "rmplc", "import", options.dxc / "models" / (circuit + ".xml"), "-o", model],
                       check=True)
        times, largest, equal, smaller, larger, known = [], 0, 0, 0, 0, 0
        scenarios = sorted((options.dxc / "dxc26" / circuit).glob("*.scn"))
        for scenario in scenarios:
            command = [options.programs / "rmpl-run", "diagnose", model, "--scenario", scenario, "--format", "json"]
            begin = time.perf_counter()
            try:
                answer = subprocess.run(command + ["--count"], capture_output=True, check=True, timeout=options.seconds)
            except subprocess.TimeoutExpired:
                continue
            times.append(time.perf_counter() - begin)
            counted = json.loads(answer.stdout)
            largest = max(largest, counted["count"])
            theirs = published(scenario.read_text())
            if theirs is None:
                continue
            known += 1
            listed = json.loads(subprocess.run(command + ["--all-minimal"], capture_output=True, check=True).stdout)
            ours = {frozenset(d["modes"]) for d in listed["diagnoses"]}
            size = len(next(iter(theirs)))
            if ours == theirs:
                equal += 1
            elif counted["cardinality"] < size:
                smaller += 1
                differences.append(f"{scenario.stem}: {counted['cardinality']} faults explain it (published: {size})")
            else:
                larger += 1
                lost = len(theirs - ours)
                differences.append(f"{scenario.stem}: {len(ours)} sets of {counted['cardinality']} (published: "
                                   f"{len(theirs)}, of which {lost} are not among ours)")
        times.sort()
        median = times[len(times) // 2] * 1e3 if times else float("nan")
        worst = times[-1] * 1e3 if times else float("nan")
        print(f"| {circuit} | {len(scenarios)} | {sum(t <= 1 for t in times)} | {len(times)} | {largest} | {median:.0f} | "
              f"{worst:.0f} | {known} | {equal} | {smaller} | {larger} |", flush=True)
    print()
    for difference in differences:
        print("- " + difference)


if __name__ == "__main__":
    sys.exit(main())
