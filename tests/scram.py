#!/usr/bin/env python3
# Fault trees that tcca-check writes, read back by SCRAM: the same number of minimal cut sets, the same top probability.
# SPDX-License-Identifier: MIT
"""Usage: scram.py BIN_DIR [TREES [SEED]]

Random trees go through `rmplc import` and `tcca-check fault-tree -o`; SCRAM reads both the tree and what was written, and
`rmplc import` reads that again.
Exits 77, which skips the test, where SCRAM is absent (Debian package `scram`).
"""

import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

CLOSE = 1e-5  # SCRAM prints six digits
HOURS = 1  # what SCRAM counts time in


def random_tree(draw):
    """Gates over gates and events, written from the top down: no loops."""
    gates, events = draw.randint(2, 6), draw.randint(3, 8)
    lines = ['<opsa-mef><define-fault-tree name="t">']
    for g in range(gates):
        below = [f'<gate name="g{h}"/>' for h in range(g + 1, gates)] + [f'<basic-event name="e{e}"/>' for e in range(events)]
        inputs = draw.sample(below, min(len(below), draw.randint(2, 4)))
        if g + 1 < gates and f'<gate name="g{g + 1}"/>' not in inputs:
            inputs.append(f'<gate name="g{g + 1}"/>')
        if draw.random() < 0.3:
            # Over different events: SCRAM 0.16 is wrong where two inputs of atleast come to the same.
            three = "".join(f'<basic-event name="e{e}"/>' for e in draw.sample(range(events), 3))
            inputs.append(f'<atleast min="2">{three}</atleast>')
        kind = draw.choice(["and", "or", "or"])
        lines.append(f'<define-gate name="g{g}"><{kind}>{"".join(inputs)}</{kind}></define-gate>')
    lines.append("</define-fault-tree><model-data>")
    for e in range(events):
        chance = f'<float value="{draw.choice([0.01, 0.1, 0.25])}"/>'
        if draw.random() < 0.5:
            chance = f'<exponential>{chance}<system-mission-time unit="hours"/></exponential>'
        lines.append(f'<define-basic-event name="e{e}">{chance}</define-basic-event>')
    return "\n".join(lines + ["</model-data></opsa-mef>"])


def of_scram(path):
    result = subprocess.run(["scram", "--bdd", "--probability", "true", "--mission-time", str(HOURS), str(path)],
                            capture_output=True, text=True)
    found = re.search(r'<sum-of-products [^>]*products="(\d+)"[^>]*probability="([^"]*)"', result.stdout)
    assert found, f"scram: {result.stdout} {result.stderr}"
    return int(found[1]), float(found[2])


def answer_of(programs, plant, top, written):
    return json.loads(subprocess.run(
        [programs / "tcca-check", "fault-tree", plant, "--top", f"{top} = failed", "--within", f"{HOURS}h", "-o", written,
         "--format", "json"], check=True, capture_output=True, text=True).stdout)


def main():
    scram = shutil.which("scram") is not None
    programs = pathlib.Path(sys.argv[1])
    trees = int(sys.argv[2]) if len(sys.argv) > 2 else 40
    draw = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    for number in range(trees):
        with tempfile.TemporaryDirectory() as folder:
            tree = pathlib.Path(folder) / "tree.xml"
            plant = pathlib.Path(folder) / "tree.tcca"
            written = pathlib.Path(folder) / "written.xml"
            tree.write_text(random_tree(draw))
            subprocess.run([programs / "rmplc", "import", tree, "-o", plant], check=True)
            answer = answer_of(programs, plant, "g0", written)
            subprocess.run([programs / "rmplc", "import", written, "-o", plant], check=True)
            again = answer_of(programs, plant, "top", pathlib.Path(folder) / "again.xml")
            before, after = answer["probability"]["upper"], again["probability"]["upper"]
            if again["count"] != answer["count"] or abs(before - after) > 1e-9 * before:
                print(f"tree {number}: {answer['count']} sets, {before}; read again: {again['count']}, {after}")
                print(tree.read_text())
                return 1
            for path in (tree, written) if scram else ():
                sets, probability = of_scram(path)
                ours = answer["probability"]["upper"]
                if sets != answer["count"] or abs(ours - probability) > CLOSE * max(ours, probability):
                    print(f"tree {number}: {answer['count']} sets, {ours}; scram of {path.name}: {sets}, {probability}")
                    print(tree.read_text())
                    return 1
    if not scram:
        print(f"{trees} trees there and back; scram is absent (Debian package scram): skipped")
        return 77
    print(f"{trees} trees agree")
    return 0


sys.exit(main())
