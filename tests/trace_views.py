#!/usr/bin/env python3
# Views of a trace are those of the flight that it is of; and a trace without its models is told by its names.
# SPDX-License-Identifier: MIT
"""Usage: trace_views.py ROOT PROGRAMS"""

import csv
import io
import json
import pathlib
import re
import subprocess
import sys
import tempfile

SCENARIO = re.compile(r'^scenario\s+"((?:[^"\\]|\\.)*)"\s*\{(.*?)^\}', re.DOTALL | re.MULTILINE)
NAMED = {key: re.compile(rf'^\s*{key}\s+"([^"]*)"', re.MULTILINE) for key in ("program", "plant")}
# A scenario of each is flown, the shortest ones.
FILES = ("propulsion/burn.scn", "power/power.scn", "flash-lamp/flash.scn")


def run(*words, status=(0, 1), **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, check=False, timeout=300, **options)
    assert done.returncode in status, (words, done.returncode, done.stderr.decode())
    return done


def rows(text: str) -> list[list[str]]:
    """What changes, without what a trace does not tell: what the scenario expected, and that nothing is marked in the end."""
    return [row for row in csv.reader(io.StringIO(text, newline="")) if row[1] != "verdict" and (row[1] != "marking" or row[3])]


def check_file(programs, scenario, folder):
    count = 0
    for name, body in SCENARIO.findall(scenario.read_text(encoding="utf-8")):
        models = [scenario.parent / NAMED[key].search(body)[1] for key in ("program", "plant")]
        trace, own, other = folder / "flight.jsonl", folder / "own.csv", folder / "other.csv"
        vcd, again = folder / "own.vcd", folder / "other.vcd"
        run(programs / "rmpl-run", "scenario", "-q", scenario, "--only", name, "--trace", trace, "--trace-detail", "beliefs", "--csv", own,
            "--vcd", vcd)
        told = run(programs / "rmpl-run", "report", trace, *models, "--csv", other, "--vcd", again, "--mcap", folder / "other.mcap",
                   "--report", folder / "other.html", status=(0,))
        assert rows(own.read_text()) == rows(other.read_text()), (scenario, name)
        # Without bits: those of the locations say in the end that nothing is marked.
        lines = [[line for line in file.read_text().splitlines() if line[:1] not in "01" and not line.startswith("$comment")] for file in (vcd, again)]
        assert lines[0] == lines[1], (scenario, name)
        assert told.stdout, (scenario, name)
        # Of a trace of changes all but the belief.
        run(programs / "rmpl-run", "scenario", "-q", scenario, "--only", name, "--trace", trace)
        run(programs / "rmpl-run", "report", "-q", trace, *models, "--csv", other, status=(0,))
        without = [[row for row in rows(file.read_text()) if row[1] != "belief"] for file in (own, other)]
        assert without[0] == without[1], (scenario, name)
        # Without models: names, and no words of theirs.
        run(programs / "rmpl-run", "report", "-q", trace, "--csv", other, "--report", folder / "other.html", status=(0,))
        modes = [[row[:4] for row in rows(file.read_text()) if row[1] in ("estimate", "truth", "goal", "reading")] for file in (own, other)]
        assert sorted(modes[0]) == sorted(modes[1]), (scenario, name)
        count += 1
        if count == 2:
            break
    return count


def check_refusals(programs, root, folder):
    """Bad input is refused, and nothing is written."""
    models = [root / "examples/propulsion/burn.rmpl", root / "examples/propulsion/propulsion.tcca"]
    for text in ("", "no json\n", '{"cycle":0}\n', '{"cycle":0,"time":0,"estimate":{"engine":"off"}}\n', '[]\n',
                 '{"cycle":0,"time":0,"estimate":{"engine":"purple"}}\n'):
        trace, page = folder / "wrong.jsonl", folder / "none.html"
        trace.write_text(text)
        done = run(programs / "rmpl-run", "report", trace, *models, "--report", page, status=(2,))
        assert not page.exists() and done.stderr, text
    scenario, trace = root / "examples/propulsion/burn.scn", folder / "flight.jsonl"
    run(programs / "rmpl-run", "scenario", "-q", scenario, "--only", "fire and stop", "--trace", trace)
    first = trace.read_text().splitlines()[0]
    for number in (0, -1, 1.5, True, 1.8446744073709552e19, 18446744073709551615, "1"):
        (folder / "wrong.jsonl").write_text(json.dumps({**json.loads(first), "marking": [number]}) + "\n")
        done = run(programs / "rmpl-run", "report", folder / "wrong.jsonl", *models, "--report", page, status=(2,))
        assert not page.exists() and b"wrong.jsonl:1:" in done.stderr, (number, done.stderr)
    done = run(programs / "rmpl-run", "report", folder / "wrong.jsonl", models[0], status=(2,))
    assert b"PROGRAM and PLANT" in done.stderr, done.stderr


def check_torn(programs, root, folder):
    """A trace that ends within a line is told up to the line before."""
    scenario = root / "examples/propulsion/burn.scn"
    models = [root / "examples/propulsion/burn.rmpl", root / "examples/propulsion/propulsion.tcca"]
    trace, table = folder / "flight.jsonl", folder / "torn.csv"
    run(programs / "rmpl-run", "scenario", "-q", scenario, "--only", "fire and stop", "--trace", trace, "--trace-detail", "cycles")
    whole = trace.read_bytes()
    lines = whole.splitlines()
    trace.write_bytes(b"\n".join(lines[:9]) + b"\n" + lines[9][:20])
    run(programs / "rmpl-run", "report", "-q", trace, *models, "--csv", table, status=(0,))
    assert max(float(row[0]) for row in rows(table.read_text())[1:]) <= json.loads(lines[8])["time"]


def main(root: pathlib.Path, programs: pathlib.Path) -> int:
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        count = sum(check_file(programs, root / "examples" / file, folder) for file in FILES if (root / "examples" / file).exists())
        check_refusals(programs, root, folder)
        check_torn(programs, root, folder)
    print(f"{count} flights, each the same from its trace")
    return 0


if __name__ == "__main__":
    sys.exit(main(*(pathlib.Path(word).resolve() for word in sys.argv[1:3])))
