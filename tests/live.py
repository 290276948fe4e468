#!/usr/bin/env python3
# Telemetry through a pipe: every line is answered when it is there, as the same log in a file is, in bounded memory.
# SPDX-License-Identifier: MIT
"""Usage: live.py ROOT PROGRAMS."""

import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

MODES = {"nav": "earth-relative", "att": "cruise-orient", "lander": "connected", "entry": "not-initiated"}
LINES = [
    {"time": 0, "estimate": {"engine": "off", **MODES}, "observations": {}},
    {"time": 0.5, "estimate": {"engine": "heating", **MODES}, "command": {}},
    {"time": 0.5, "estimate": {"engine": "heating", **MODES}},
    {"time": 43.8, "estimate": {"engine": "standby", **MODES}},
    {"time": 44.2, "estimate": {"engine": "standby", **MODES}},
]
LONG = 30_000
GROWTH_KB = 8 * 1024


def start(command: list) -> subprocess.Popen:
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)


def told(run: subprocess.Popen, line: dict) -> None:
    run.stdin.write((json.dumps(line) + "\n").encode())
    run.stdin.flush()


def compare(command: list, late: int) -> None:
    """`late`: how many lines later the answer to a line comes."""
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder, "log.jsonl")
        log.write_text("".join(json.dumps(line) + "\n" for line in LINES), encoding="utf-8")
        expected = subprocess.run([*command, "--log", log], check=True, capture_output=True).stdout.splitlines()
    assert len(expected) == len(LINES) - late, expected
    with start([*command, "--log", "-"]) as run:
        for i, line in enumerate(LINES):
            told(run, line)
            if i >= late:
                answer = run.stdout.readline().rstrip(b"\n")
                assert answer == expected[i - late], f"line {i}: {answer!r}, not {expected[i - late]!r}"
        run.stdin.close()
        assert run.stdout.read() == b""
    assert run.returncode == 0


def interrupt(command: list) -> None:
    """While it waits for a line that does not come."""
    with subprocess.Popen(
        [*command, "--log", "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, bufsize=0
    ) as run:
        told(run, LINES[0])
        run.stdout.readline()
        run.send_signal(signal.SIGINT)
        assert run.wait(timeout=20) == 3
        assert run.stderr.read() == b"rmpl-run: interrupted after 1 line\n"


def resident(run: subprocess.Popen) -> int:
    status = pathlib.Path("/proc", str(run.pid), "status").read_text(encoding="utf-8")
    return int(re.search(r"VmRSS:\s*(\d+) kB", status).group(1))


def fly_long(command: list, late: int) -> None:
    with start([*command, "--log", "-"]) as run:
        after_warming_up = 0
        for i in range(LONG):
            told(run, {**LINES[0], "time": i})
            if i >= late:
                run.stdout.readline()
            if i == LONG // 10:
                after_warming_up = resident(run)
        grown = resident(run) - after_warming_up
        run.stdin.close()
    assert grown < GROWTH_KB, f"{grown} kB more after {LONG} lines"


def main(root: pathlib.Path, programs: pathlib.Path) -> int:
    entry = root / "examples/mars-entry"
    plant = entry / "mars_lander.tcca"
    program = entry / "mars_entry.rmpl"
    estimate = [programs / "rmpl-run", "estimate", plant, "--live-clocks"]
    sequence = [programs / "rmpl-run", "sequence", program]
    compare([*estimate, "--stats"], 0)
    compare([*estimate, "--estimator", "exact"], 0)
    compare(sequence, 1)
    compare([*sequence, plant], 1)
    interrupt(estimate)
    fly_long(estimate, 0)
    fly_long(sequence, 1)
    print("answered line by line")
    return 0


if __name__ == "__main__":
    sys.exit(main(*map(pathlib.Path, sys.argv[1:])))
