#!/usr/bin/env python3
# The goldens of plans beside what the twin answers: to be read, not a test. SPDX-License-Identifier: MIT
"""For each golden of `rmpl-run plan`: its comment, what it expects, and what `game` prints for the same model, start and
goal. What follows `--` goes to `game`, as in `plans.py build/release/tests/bin/game -- --bounds --cycle 60`."""

import argparse
import pathlib
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests" / "golden"))
from golden import Golden  # noqa: E402

TIMEOUT = 60  # seconds; plants of many components are too large for the twin


def question(command: list[str]) -> list[str]:
    """The model, the start and the goal of a command line of `rmpl-run plan`."""
    kept: list[str] = []
    words = iter(command)
    for word in words:
        if word in ("--goal", "--from"):
            kept += [word, next(words)]
        elif word in ("--format", "--reconfigurer", "--component"):
            next(words)
        elif not word.startswith("--"):
            kept.append(word)
    return kept


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("game", type=pathlib.Path, help="the program")
    parser.add_argument("rest", nargs="*", help="options for it")
    arguments = parser.parse_args()
    for path in sorted((ROOT / "tests" / "golden" / "plan").glob("*.golden")):
        golden = Golden(path)
        command = shlex.split(golden.text("command").replace("{source}", str(ROOT)), comments=True)[2:]
        if "--goal" not in command:
            continue
        print(f"==== {path.stem}: {golden.comment.strip()}\n-- expected:\n{golden.text('stdout')}-- twin:", flush=True)
        with tempfile.TemporaryDirectory() as directory:
            for section, name, text in golden.sections:
                if section == "file":
                    pathlib.Path(directory, name).write_text(text, encoding="utf-8")
            try:
                subprocess.run([arguments.game.resolve(), *question(command), *arguments.rest], cwd=directory,
                               stderr=subprocess.STDOUT, timeout=TIMEOUT, check=False)
            except subprocess.TimeoutExpired:
                print("too large")
            sys.stdout.flush()
    return 0


if __name__ == "__main__":
    sys.exit(main())
