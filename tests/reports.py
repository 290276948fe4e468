#!/usr/bin/env python3
# The report of every example, and of a model program, has its drawings; one that there cannot be is told.
# SPDX-License-Identifier: MIT
"""Usage: reports.py ROOT PROGRAMS

Of each file of scenarios one for each plant is flown. Skipped (77) where Graphviz is not there.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
SCENARIO = re.compile(r'scenario\s+"((?:[^"\\]|\\.)*)"\s*\{(.*?)\n\}', re.DOTALL)
PLANT = re.compile(r'plant\s+"([^"]*)"')
SOFTWARE = {
    "m.rmpl": "variable x : { no, yes };\nmodel Idle() :: { always x = no }\n",
    "p.rmpl": "Main() :: { when x = no donext true }\n",
    "s.scn": 'scenario "go" {\n  program "p.rmpl";\n  plant "m.rmpl";\n  cycle 1 s;\n  duration 5 s;\n}\n',
}


def fly(programs: pathlib.Path, scenario: pathlib.Path, name: str, page: pathlib.Path, **more) -> subprocess.CompletedProcess:
    done = subprocess.run([programs / "rmpl-run", "scenario", scenario, "--only", name, "--report", page],
                          capture_output=True, text=True, timeout=600, check=False, **more)
    assert done.returncode in (0, 1), (scenario, name, done)
    return done


def drawings(page: pathlib.Path) -> list[dict]:
    """What the page has of each model that it shows."""
    text = page.read_text(encoding="utf-8")
    key = '"drawings":'
    places = [found.end() for found in re.finditer(re.escape(key), text)]
    return [json.JSONDecoder().raw_decode(text[place:])[0] for place in places if text[place] == "{"]


def check(programs: pathlib.Path, scenario: pathlib.Path, name: str, page: pathlib.Path) -> None:
    done = fly(programs, scenario, name, page)
    found = drawings(page)
    assert found, (scenario, name)
    for one in found:
        assert one["missing"] == "" and "<svg" in one["program"] and "<svg" in one["plant"], (scenario, name, one["missing"])
    assert "drawing" not in done.stderr, (scenario, name, done.stderr)


def main(root: pathlib.Path, programs: pathlib.Path) -> int:
    if shutil.which("dot") is None:
        print("skipped: there is no dot")
        return SKIPPED
    count = 0
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        page = folder / "report.html"
        for name, text in SOFTWARE.items():
            (folder / name).write_text(text)
        for scenario in [*sorted((root / "examples").glob("*/*.scn")), folder / "s.scn"]:
            plants = set()
            for name, body in SCENARIO.findall(scenario.read_text(encoding="utf-8")):
                plant = PLANT.search(body)[1]
                if plant in plants:
                    continue
                plants.add(plant)
                check(programs, scenario, name, page)
                count += 1
        # Without Graphviz the page is made, and what it lacks is told.
        done = fly(programs, folder / "s.scn", "go", page, env={**os.environ, "PATH": "/nonexistent"})
        assert "warning: the report lacks a drawing: dot, the layout program of Graphviz, is not installed" in done.stderr, done
        assert all(one["missing"] for one in drawings(page))
    print(f"{count} reports")
    return 0 if count > 5 else 1


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()))
