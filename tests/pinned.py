#!/usr/bin/env python3
# Same input, same bytes, in every build and on every machine: what the programs write over the examples is pinned.
# SPDX-License-Identifier: MIT
"""Usage: pinned.py ROOT PROGRAMS [--rebase]

tests/pinned.txt holds a line a command: the SHA-256 of what it writes, and the command, which runs in examples/. Seconds
and bytes of memory are left out. --rebase writes the file anew: then say in the commit why the bytes have changed.
"""

import hashlib
import os
import pathlib
import re
import subprocess
import sys

MEASURED = re.compile(rb'"(?:seconds|peak_bytes|states_per_second)":\s*[-+.0-9e]+')
COMMENT = "# SHA-256 of what each command writes, run in examples/; tests/pinned.py checks it, and --rebase writes it anew.\n"


def digest(command: str, root: pathlib.Path, programs: pathlib.Path) -> str:
    environment = {"PATH": f"{programs}{os.pathsep}{os.environ['PATH']}", "LC_ALL": "C.UTF-8"}
    done = subprocess.run(command, shell=True, cwd=root / "examples", env=environment, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=300, check=False)
    return hashlib.sha256(MEASURED.sub(b"", done.stdout) + str(done.returncode).encode()).hexdigest()


def main(root: pathlib.Path, programs: pathlib.Path, rebase: bool) -> int:
    pinned = root / "tests/pinned.txt"
    lines = [line for line in pinned.read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]
    differ, written = 0, COMMENT
    for line in lines:
        expected, command = line.split("  ", 1)
        found = digest(command, root, programs)
        written += f"{found}  {command}\n"
        if found != expected:
            differ += 1
            print(f"{'rebased' if rebase else 'other bytes'}: {command}")
    if rebase:
        pinned.write_text(written, encoding="utf-8")
    print(f"{len(lines)} commands, {differ} differ")
    return 0 if rebase or (lines and not differ) else 1


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), "--rebase" in sys.argv[3:]))
