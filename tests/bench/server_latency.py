#!/usr/bin/env python3
# How long an edit waits for its diagnostics: files of 2,000 and 20,000 lines, one edit after the other.
# SPDX-License-Identifier: MIT
"""Usage: tests/bench/server_latency.py [BUILD] [EDITS]     BUILD defaults to build/release, EDITS to 200.

Makes a plant of many component types, a control program over it, and a scenario; opens them, types into the middle of each,
one character at a time, and waits for the diagnostics of that version. Prints the median and the 99th percentile.
"""

import importlib.util
import pathlib
import sys
import tempfile
import time

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
BUILD = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else SOURCE / "build/release"
EDITS = int(sys.argv[2]) if len(sys.argv) > 2 else 200
COMPONENT = """component C{k} {{
  input  cmd    : {{ none, standby, fire, off }};
  output thrust : {{ zero, full }};
  output power  : {{ zero, nominal }};
  output temp   : {{ low, nominal, high }};

  initial off;
  mode  off     {{ thrust = zero & power = zero }};
  mode  heating {{ thrust = zero & power = nominal & temp = low }};
  mode  standby {{ thrust = zero & power = nominal & temp = nominal }} reward 1;
  mode  firing  {{ thrust = full & power = nominal & temp = nominal }} reward -5;
  fault failed reward -20;

  off     -> heating when cmd = standby;
  heating -> off     when cmd = off;
  heating -> standby when cmd != off in [30 s, 60 s];
  standby -> off     when cmd = off;
  standby -> firing  when cmd = fire;
  firing  -> standby when cmd = standby;
  any     -> failed  with 0.001;
}}
"""
DEFINITION = """Part{k}() :: {{
  c0 = standby;
  t1 = 0;
  when t1 >= 270 min donext {{
    c1 = standby;
    do {{
      always (c2 = standby),
      when c3 = standby donext c4 = firing
    }} watching c5 = firing
  }}
}}
"""
SCENARIO = 'scenario "s" {\n  program "p.rmpl" main Main;\n  plant "p.tcca";\n  cycle 1 s;\n  duration 10 h;\n  seed 1;\n%s}\n'


def client_module():
    spec = importlib.util.spec_from_file_location("server", SOURCE / "tests/server.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def plant(lines: int) -> str:
    count = max(6, lines // 26)
    types = "".join(COMPONENT.format(k=k) + "\n" for k in range(count))
    instances = "".join(f"  c{k} : C{k};\n" for k in range(count))
    rest = "".join(f"  control c{k}.cmd default none;\n  observe c{k}.thrust, c{k}.power, c{k}.temp;\n" for k in range(count))
    return types + "plant P {\n" + instances + rest + "}\n"


def program(lines: int) -> str:
    parts = lines // 12
    calls = "".join(f"Group{g}() :: {{ {', '.join(f'Part{k}()' for k in range(g, parts, max(1, parts // 10)))} }}\n" for g in range(min(10, parts)))
    return "Main() :: { " + "; ".join(f"Group{g}()" for g in range(min(10, parts))) + " }\n" + calls + "".join(DEFINITION.format(k=k) + "\n" for k in range(parts))


def scenario(lines: int) -> str:
    return SCENARIO % "".join(f"  at {k} s observe c{k % 6}.thrust = zero;\n" if k < 50 else f"  expect c{k % 6} = standby within {k} s;\n" for k in range(lines))


def measure(server, files: dict[str, str], name: str) -> None:
    with tempfile.TemporaryDirectory() as at:
        folder = pathlib.Path(at)
        for file, text in files.items():
            (folder / file).write_text(text, encoding="utf-8")
        client = server.Client(BUILD / "bin/rmplc", folder)
        client.start()
        for file in files:
            client.open(file)
        found = client.findings(name)
        assert not found, found[:3]
        lines = files[name].count("\n")
        row = lines // 2
        typed = "// x is y"
        client.change(name, "\n", (row, 0), (row, 0))
        client.findings(name)
        times = []
        for edit in range(EDITS):
            at = edit % len(typed)
            start = time.perf_counter()
            if at == 0 and edit > 0:
                client.change(name, typed[0], (row, 0), (row, len(typed)))
            else:
                client.change(name, typed[at], (row, at), (row, at))
            client.findings(name)
            times.append(1000 * (time.perf_counter() - start))
        client.end()
        times.sort()
        print(f"| {name.rpartition('.')[2]} | {lines} | {times[len(times) // 2]:.0f} ms | {times[min(len(times) - 1, len(times) * 99 // 100)]:.0f} ms |", flush=True)


def main() -> None:
    server = client_module()
    print("| edited | lines | median | 99 % within |\n|---|---|---|---|")
    small = {"p.tcca": plant(200), "p.rmpl": program(200), "p.scn": scenario(40)}
    for lines in (2_000, 20_000):
        for name, make in (("p.tcca", plant), ("p.rmpl", program), ("p.scn", scenario)):
            measure(server, {**small, name: make(lines)}, name)


if __name__ == "__main__":
    main()
