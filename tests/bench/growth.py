#!/usr/bin/env python3
# Measures how the time of an estimation cycle grows, and draws it: docs/growth-*.svg.
# SPDX-License-Identifier: MIT
"""Usage: tests/bench/growth.py [BIN [DOCS [TABLE…]]]   BIN defaults to build/release/bin; without DOCS, or with - for it,
nothing is drawn. Tables are components, kappa, observations and model-programs; all where none is named.

The plants are trees: each component is a switch that passes power on to two others, may be commanded, and can fail open,
stuck or unknown; a sensor reads what comes out of it. All of it is one connected group. Of each run the tables show the
median, the 99th percentile and the worst cycle, as `rmpl-run estimate --stats` tells them.

The model programs are pumps in parallel, of five locations each (model_program_bench.cpp); the table shows medians.
"""

import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

import plot

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
BIN = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else SOURCE / "build/release/bin"
DOCS = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 and sys.argv[2] != "-" else None
ASKED = sys.argv[3:]
CYCLES = 2000
COMPONENTS = (10, 20, 50, 100, 200, 500, 1000, 2000, 5000)
KAPPAS = (1, 2, 4, 8, 16, 32, 64, 128, 256)
OBSERVATIONS = (0, 10, 20, 40, 60, 80, 100)

SWITCH = """
component Switch {
  input  cmd : { none, close, open };
  input  inlet : { off, on };
  output outlet : { off, on };
  initial closed;
  mode  closed { outlet = inlet };
  mode  opened { outlet = off };
  fault stuck  { outlet = inlet };
  fault dead   { outlet = off };
  fault unknown;
  closed -> opened when cmd = open;
  opened -> closed when cmd = close;
  closed -> stuck  when cmd = open with RATE1;
  any nominal -> dead with rate RATE2 /h;
  any -> unknown with rate 1e-6 /h;
}
"""


def plant(components: int, observed: int) -> str:
    """A binary tree of switches; the `observed` first outlets are read, and every tenth switch is commanded."""
    lines = ["component Source { output outlet : { off, on }; initial on; mode on { outlet = on };",
             "  fault flat { outlet = off }; on -> flat with rate 1e-6 /h; }"]
    # No two rates are the same, as in a real plant: equal ones would make every state a tie.
    rng = random.Random(7)
    for i in range(components - 1):
        lines.append(SWITCH.replace("Switch", f"Switch{i}").replace("RATE1", f"{0.001 * (1 + rng.random()):.6f}")
                     .replace("RATE2", f"{1e-4 * (1 + rng.random()):.9f}"))
    lines.append("plant Tree {\n  source : Source;")
    lines += [f"  s{i} : Switch{i};" for i in range(components - 1)]
    for i in range(components - 1):
        parent = "source" if i < 2 else f"s{(i - 2) // 2}"
        lines.append(f"  {parent}.outlet = s{i}.inlet;")
        if i % 10 == 5:
            lines.append(f"  control s{i}.cmd default none;")
    lines += [f"  observe s{i}.outlet;" for i in range(min(observed, components - 1))]
    return "\n".join(lines) + "\n}\n"


def log(components: int, observed: int) -> str:
    """Every fifth cycle one commanded switch opens or closes; what is read follows; half way a switch dies."""
    rng = random.Random(3)
    closed = [True] * (components - 1)
    dead: int | None = None
    lines = []
    for cycle in range(1, CYCLES + 1):
        command = {}
        if cycle % 5 == 0:
            i = rng.randrange(0, max(1, (components - 2) // 10)) * 10 + 5
            if i < components - 1 and i != dead:
                closed[i] = not closed[i]
                command = {f"s{i}.cmd": "close" if closed[i] else "open"}
        if cycle == CYCLES // 2:
            dead = (components - 1) // 3
        on = []
        for i in range(components - 1):
            on.append((i < 2 or on[(i - 2) // 2]) and closed[i] and i != dead)
        seen = {f"s{i}.outlet": "on" if on[i] else "off" for i in range(min(observed, components - 1))}
        lines.append(json.dumps({"time": cycle / 2, "command": command, "observations": seen}))
    return "\n".join(lines) + "\n"


def measure(components: int, kappa: int, observed: int) -> tuple[float, float, float]:
    """Median, 99th percentile and worst cycle, in milliseconds."""
    with tempfile.TemporaryDirectory() as folder:
        model, inputs = pathlib.Path(folder, "tree.tcca"), pathlib.Path(folder, "in.jsonl")
        model.write_text(plant(components, observed))
        inputs.write_text(log(components, observed))
        done = subprocess.run([BIN / "rmpl-run", "estimate", model, "--log", inputs, "-k", str(kappa), "--stats"],
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=True)
    found = re.search(r"a cycle: (\S+) ms median, (\S+) ms 99th percentile, (\S+) ms worst", done.stderr)
    if found is None:
        sys.exit(f"no times in: {done.stderr}")
    return tuple(float(x) for x in found.groups())  # type: ignore[return-value]


def table(name: str, label: str, xs: tuple[int, ...], rows: list[tuple[float, float, float]]) -> None:
    print(f"| {label} | median ms | 99 % ms | worst ms |\n|---|---|---|---|")
    for x, (median, most, worst) in zip(xs, rows):
        print(f"| {x} | {median:g} | {most:g} | {worst:g} |")
    print(flush=True)
    if DOCS:
        lines = {"median": 0, "99 %": 1, "worst": 2}
        plot.draw(DOCS / f"growth-{name}.svg", label, "ms a cycle",
                  {line: [(x, row[column]) for x, row in zip(xs, rows)] for line, column in lines.items()},
                  linear_x=min(xs) == 0)


def model_programs() -> None:
    """Runs the benchmark, whose medians are in microseconds."""
    done = subprocess.run([BIN.parent / "tests/bin/bench", "--benchmark_filter=model_", "--benchmark_format=json"],
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True)
    series: dict[str, dict[int, float]] = {}
    for run in json.loads(done.stdout)["benchmarks"]:
        name, locations = run["name"].split("/")
        series.setdefault(name.removeprefix("model_"), {})[int(locations)] = run["median_us"] / 1000
    sizes = sorted({locations for points in series.values() for locations in points})
    print("| locations | " + " | ".join(f"{name}, ms" for name in series) + " |\n" + "|---" * (1 + len(series)) + "|")
    for size in sizes:
        cells = [f"{points[size]:.3g}" if size in points else "" for points in series.values()]
        print(f"| {size} | " + " | ".join(cells) + " |")
    print(flush=True)
    if DOCS:
        plot.draw(DOCS / "growth-model-programs.svg", "locations", "ms an update",
                  {name: sorted(points.items()) for name, points in series.items()}, linear_x=False)


def main() -> None:
    tables = {
        "components": lambda: table("components", "components", COMPONENTS,
                                    [measure(n, 16, min(n, 100)) for n in COMPONENTS]),
        "kappa": lambda: table("kappa", "states kept (100 components)", KAPPAS, [measure(100, k, 99) for k in KAPPAS]),
        "observations": lambda: table("observations", "sensors (100 components)", OBSERVATIONS,
                                      [measure(100, 16, o) for o in OBSERVATIONS]),
        "model-programs": model_programs,
    }
    unknown = [name for name in ASKED if name not in tables]
    if unknown:
        sys.exit(f"{unknown[0]} is no table; expected one of {', '.join(tables)}")
    for name, make in tables.items():
        if not ASKED or name in ASKED:
            make()


if __name__ == "__main__":
    main()
