#!/usr/bin/env python3
# Ctrl-C in the middle of a run: it ends soon, says so, and every line that it wrote is whole.
# SPDX-License-Identifier: MIT
"""Usage: interrupt.py ROOT PROGRAMS."""

import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

LINES = 200_000  # more than anyone estimates between the first line and the signal


def main(root: pathlib.Path, programs: pathlib.Path) -> int:
    plant = root / "examples/mars-entry/mars_lander.tcca"
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder, "flight.jsonl")
        log.write_text("".join(f'{{"time": {i}}}\n' for i in range(1, LINES + 1)), encoding="utf-8")
        with subprocess.Popen(
            [programs / "rmpl-run", "estimate", plant, "--log", "-"],
            stdin=log.open("rb"),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            bufsize=0,  # what is read ahead would be lost to communicate
        ) as run:
            first = run.stdout.readline()
            run.send_signal(signal.SIGINT)
            rest, errors = run.communicate(timeout=60)
    lines = (first + rest).splitlines(keepends=True)
    for line in lines:
        assert line.endswith(b"\n"), "a line that is cut"
        json.loads(line)
    assert 0 < len(lines) < LINES, f"{len(lines)} lines"
    assert run.returncode == 3, f"exit {run.returncode}"
    assert errors.decode() == f"rmpl-run: interrupted after {len(lines)} line{'s' * (len(lines) != 1)}\n", errors
    print(f"{len(lines)} whole lines")
    within_a_line(plant, programs)
    within_an_update(programs)
    with_millions_of_states(programs)
    return 0


def within_a_line(plant: pathlib.Path, programs: pathlib.Path) -> None:
    """A line that stands for many cycles: what was not worked out to its end is not told."""
    with subprocess.Popen([programs / "rmpl-run", "estimate", plant, "--log", "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, bufsize=0) as run:
        run.stdin.write(b'{"time": 1}\n{"time": 1000000000, "unchanged": 999999998}\n')
        first = run.stdout.readline()
        run.send_signal(signal.SIGINT)
        rest, errors = run.communicate(timeout=60)
    assert json.loads(first)["time"] == 1 and not rest, first + rest
    assert run.returncode == 3, f"exit {run.returncode}"
    assert errors.decode() == "rmpl-run: interrupted after 1 line\n", errors


def within_an_update(programs: pathlib.Path) -> None:
    """The whole belief of many components, none of which is seen: one update would take minutes."""
    many = range(9)
    component = """component T { output a : { x, y }; initial m; mode m { a = x }; mode n { a = y }; fault f; fault g { a = y };
        m -> n in [1 s, 5 s]; n -> m in [2 s, 3 s]; any -> f with 0.1; m, n -> g with 0.05; f -> g with 0.02; }"""
    tied = " | ".join(f"c{i}.a = x" for i in many) + " | c0.a != x"
    with tempfile.TemporaryDirectory() as folder:
        plant = pathlib.Path(folder, "tied.tcca")
        plant.write_text(f"{component} plant P {{ {' '.join(f'c{i} : T;' for i in many)} {tied}; }}", encoding="utf-8")
        with subprocess.Popen([programs / "rmpl-run", "estimate", plant, "--estimator", "exact", "-k", "1", "--log", "-"],
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, bufsize=0) as run:
            run.stdin.write(b'{"time": 1}\n')
            first = run.stdout.readline()
            run.stdin.write(b'{"time": 2}\n')
            time.sleep(1)
            run.send_signal(signal.SIGTERM)
            rest, errors = run.communicate(timeout=30)
    assert json.loads(first)["time"] == 1 and not rest, first + rest
    assert run.returncode == 3, f"exit {run.returncode}"
    assert errors.decode() == "rmpl-run: interrupted after 1 line\n", errors


def with_millions_of_states(programs: pathlib.Path) -> None:
    """Whatever is being done with the whole belief of fifteen breakers, its release included, an end is answered at once."""
    many = range(15)
    breaker = """component Breaker { input cmd : { none, open, close }; output load : { off, on }; initial closed;
        mode closed { load = on }; mode open { load = off }; fault welded { load = on };
        closed -> open when cmd = open; open -> closed when cmd = close; closed, open -> welded with 0.01; }
        component Bus { output volts : { low, high }; initial up; mode up { volts = high }; fault down { volts = low };
        up -> down with 0.001; }"""
    linked = " & ".join(f"b{i}.load = off" for i in many) + " -> bus.volts = high"
    controls = " ".join(f"control b{i}.cmd default none;" for i in many)
    with tempfile.TemporaryDirectory() as folder:
        plant = pathlib.Path(folder, "board.tcca")
        plant.write_text(f"{breaker} plant Board {{ bus : Bus; {' '.join(f'b{i} : Breaker;' for i in many)} {controls} {linked}; }}",
                         encoding="utf-8")
        log = pathlib.Path(folder, "log.jsonl")
        log.write_text("".join(f'{{"time": {i}}}\n' for i in range(1, 40)), encoding="utf-8")
        for moment in (0.3, 0.6, 0.9, 1.2, 1.5, 2.0, 3.0):
            with subprocess.Popen([programs / "rmpl-run", "estimate", plant, "--estimator", "exact", "-k", "1", "--log", log],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE) as run:
                time.sleep(moment)
                run.send_signal(signal.SIGTERM)
                _, errors = run.communicate(timeout=10)
            assert run.returncode == 3, f"exit {run.returncode} after {moment} s"
            assert errors.startswith(b"rmpl-run: interrupted "), errors


if __name__ == "__main__":
    sys.exit(main(*map(pathlib.Path, sys.argv[1:])))
