#!/usr/bin/env python3
# A live flight that is killed: trace, page, table, dump and MCAP are there, whole, up to the last cycle.
# SPDX-License-Identifier: MIT
"""Usage: live_views.py ROOT PROGRAMS

MCAP is read by its own library where that is installed (cmake/install-packages editors).
"""

import csv
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

VIEWS = {"report": "flight.html", "csv": "flight.csv", "vcd": "flight.vcd", "mcap": "flight.mcap"}
MAGIC = b"\x89MCAP0\r\n"
READ_MCAP = """
const {McapIndexedReader} = require('@mcap/core'); const fs = require('fs');
const bytes = fs.readFileSync(process.argv[1]);
const readable = {size: async () => BigInt(bytes.length), read: async (at, n) => new Uint8Array(bytes.subarray(Number(at), Number(at + n)))};
(async () => {
  const reader = await McapIndexedReader.Initialize({readable});
  let last = 0;
  for await (const m of reader.readMessages()) last = Number(m.logTime);
  console.log(last);
})();
"""


def command(root, programs, folder, *more):
    lander = f"exec {sys.executable} {root / 'examples/live/lander.py'}"
    views = [word for name, file in VIEWS.items() for word in (f"--{name}", folder / file)]
    return [str(word) for word in (programs / "rmpl-run", "execute", root / "examples/mars-entry/mars_entry.rmpl",
                                   root / "examples/mars-entry/mars_lander.tcca", "--exec", lander, "--cycle", "0.05 s",
                                   "--trace", folder / "flight.jsonl", "--trace-detail", "cycles", *views, *more)]


def await_end_of_views(flight, folder):
    """The other process writes once more after the flight is dead, then ends: it was the last to hold standard error."""
    flight.communicate(timeout=120)
    left = sorted(file.name for file in folder.iterdir() if file.name.startswith("."))
    assert not left, f"left unfinished: {left}"


def last_whole_cycle(folder, trace):
    """A kill between the trace and the other process leaves one of the two a cycle ahead; a line of the trace may be cut."""
    *whole, cut = trace.read_text(encoding="utf-8").split("\n")
    lines = [json.loads(line) for line in whole]
    assert len(lines) >= 30 and [line["cycle"] for line in lines] == list(range(len(lines))), cut
    seen = int(re.findall(r"^#(\d+)$", (folder / "flight.vcd").read_text(encoding="utf-8"), re.MULTILINE)[-1])
    times = [round(line["time"] * 1e9) for line in lines]
    assert times[-2] <= seen <= 2 * times[-1] - times[-2], (seen, times[-3:])
    return lines[-1 if seen >= times[-1] else -2]["time"]


def rows_up_to(file, last):
    """The rows of a table but those of beliefs, which a trace of cycles does not hold, and those after `last`."""
    with file.open(newline="", encoding="utf-8") as table:
        return [row for row in csv.DictReader(table) if row["kind"] != "belief" and float(row["time"]) <= last]


def check_views(folder, last_time, modules, killed):
    with (folder / "flight.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert any(row["kind"] == "estimate" and row["name"] == "engine" and row["value"] == "heating" for row in rows), rows[:20]
    vcd = (folder / "flight.vcd").read_text(encoding="utf-8")
    assert "$enddefinitions" in vcd and f"#{round(last_time * 1e9)}\n" in vcd, vcd[-200:]
    mcap = (folder / "flight.mcap").read_bytes()
    assert mcap.startswith(MAGIC) and mcap.endswith(MAGIC)
    if (modules / "@mcap/core").is_dir() and shutil.which("node"):
        done = subprocess.run(["node", "-e", READ_MCAP, str(folder / "flight.mcap")], env={"NODE_PATH": str(modules), "PATH": os.environ["PATH"]},
                              capture_output=True, text=True, check=False)
        assert done.returncode == 0 and int(done.stdout) > 0, done
    else:
        print("left out: @mcap/core is not in build/node_modules; cmake/install-packages editors puts it there")
    page = (folder / "flight.html").read_text(encoding="utf-8")
    assert page.rstrip().endswith("</html>")
    assert ('"summary":"up to' in page) == killed, "the page says how the flight ended"


def check_killed(root, programs, modules):
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        flight = subprocess.Popen(command(root, programs, folder), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)
        trace = folder / "flight.jsonl"
        end = time.monotonic() + 120
        while not trace.exists() or trace.read_bytes().count(b"\n") < 30:
            assert time.monotonic() < end and flight.poll() is None, (flight.poll(), flight.stdout.read())
            time.sleep(0.05)
        os.killpg(flight.pid, signal.SIGKILL)  # the flight and its plant
        await_end_of_views(flight, folder)
        last = last_whole_cycle(folder, trace)
        check_views(folder, last, modules, True)
        # Any view of the trace that is left: the same changes.
        models = [root / "examples/mars-entry/mars_entry.rmpl", root / "examples/mars-entry/mars_lander.tcca"]
        subprocess.run([programs / "rmpl-run", "report", "-q", trace, *models, "--csv", folder / "again.csv"], check=True)
        assert rows_up_to(folder / "flight.csv", last) == rows_up_to(folder / "again.csv", last)
        print(f"killed after {last:g} s: all views are there up to the last cycle")


def check_whole(root, programs, modules):
    """A flight that ends by itself says so in its views."""
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        done = subprocess.run(command(root, programs, folder, "--clock", "lock-step", "--duration", "60 s", "--follow"), capture_output=True,
                              text=True, timeout=300, check=False)
        assert done.returncode == 0 and "the duration ended" in done.stdout, done
        assert not [file for file in folder.iterdir() if file.name.startswith(".")]
        last = json.loads((folder / "flight.jsonl").read_text().splitlines()[-1])
        check_views(folder, last["time"], modules, False)
        assert "the duration ended" in (folder / "flight.html").read_text(encoding="utf-8")


def check_refused(root, programs):
    """Where a view cannot be written, nothing flies and nothing is written."""
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        words = command(root, programs, folder, "--clock", "lock-step")
        words[words.index("--vcd") + 1] = str(folder / "nowhere/flight.vcd")
        done = subprocess.run(words, capture_output=True, text=True, timeout=300, check=False)
        assert done.returncode == 2 and "nowhere/flight.vcd" in done.stderr, done
        assert not list(folder.iterdir()), list(folder.iterdir())


def main(root: pathlib.Path, programs: pathlib.Path) -> int:
    modules = root / "build/node_modules"
    check_killed(root, programs, modules)
    check_whole(root, programs, modules)
    check_refused(root, programs)
    return 0


if __name__ == "__main__":
    sys.exit(main(*(pathlib.Path(word).resolve() for word in sys.argv[1:3])))
